// SPDX-License-Identifier: MIT
#include "editor/state/shown.h"

namespace patina::editor {

bool applies(Action action, const Shown& shown) {
    switch (info(action).needs) {
        case Needs::Nothing:
            return true;
        case Needs::Document:
            return shown.document != nullptr;
        case Needs::Material:
            return shown.material != nullptr;
        case Needs::AddedMaterial:
            return shown.material != nullptr && is_added(*shown.material);
        case Needs::Layer:
            return shown.layer != nullptr;
        case Needs::Group:
            return shown.layer != nullptr && shown.layer->is_group();
        case Needs::Mask:
            return shown.layer != nullptr && !shown.layer->mask.entries.empty();
        case Needs::UndoStep:
            return shown.history.can_undo;
        case Needs::RedoStep:
            return shown.history.can_redo;
    }
    return false;
}

}  // namespace patina::editor
