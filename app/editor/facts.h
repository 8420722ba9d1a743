// SPDX-License-Identifier: MIT
#pragma once

/// What is true of the editor beside its controls, for the UiMap: what is open and whether it is
/// edited, what is looked at and how, whether work is under way.

#include <string>

#include "editor/layout.h"
#include "editor/session/session.h"
#include "editor/state/shown.h"
#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

class Facts {
  public:
    struct Frame {
        const Session& session;
        const ViewState& view;
        const Shown& shown;
        const Layout& layout;
        bool quiet = false;  ///< what came of the last input has been drawn
    };
    void state(Ui& ui, const Frame& frame);

  private:
    void state_document(UiMap& map, const Shown& shown);

    DocumentPtr hashed_;  ///< whose text `content_` is the hash of
    std::string content_;
};

}  // namespace patina::editor
