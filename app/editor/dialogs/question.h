// SPDX-License-Identifier: MIT
#pragma once

/// A question before something is lost, and plain notices.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "editor/widgets/ui.h"

namespace patina::editor {

struct Question {
    struct Answer {
        std::string label;  ///< a verb
        std::function<void()> chosen;
        bool main = false;
    };
    std::string title;
    std::string text;
    std::vector<Answer> answers;  ///< from the right; Esc gives none of them
};

class QuestionDialog {
  public:
    void ask(Question question) { question_ = std::move(question); }
    bool is_open() const { return question_.has_value(); }
    void draw(Ui& ui);

  private:
    std::optional<Question> question_;
};

/// The keys and mouse buttons, as a table.
class KeysDialog {
  public:
    void open() { open_ = true; }
    bool is_open() const { return open_; }
    void draw(Ui& ui);

  private:
    bool open_ = false;
};

}  // namespace patina::editor
