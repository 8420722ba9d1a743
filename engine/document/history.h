// SPDX-License-Identifier: MIT
#pragma once

/// Undo and redo: a list of snapshots. Neighbours share what they have in common, so a step costs
/// what it changed; the oldest are forgotten when their sum exceeds a budget. One thread.

#include <cstddef>
#include <string>
#include <vector>

#include "document/edit.h"

namespace patina {

/// A guess at the memory that `after` holds and `before` does not: materials, layers and images
/// that are other nodes. Either may be null.
std::size_t added_bytes(const Document* before, const Document* after);

class History {
  public:
    explicit History(DocumentPtr opened, std::size_t budget_bytes = std::size_t{256} << 20);

    /// The snapshot that is shown. Never null.
    const DocumentPtr& document() const;

    /// Applies an edit: a new step after the current one (what could be redone is dropped), or,
    /// with the merge key of the current step and no seal between, the current step grown. An edit
    /// that changes nothing makes no step. A refused edit changes nothing; its reason is returned.
    Status apply(const Edit& edit);
    /// Ends merging: the next edit is a step of its own. Call it when a drag ends.
    void seal();

    bool can_undo() const;
    bool can_redo() const;
    void undo();  ///< does nothing when there is nothing to undo
    void redo();

    /// Labels of all steps, oldest first. Step 0 is the document as opened ("Open"), or the oldest
    /// that is remembered.
    std::vector<std::string> labels() const;
    /// The step that is shown: 0 to labels().size() - 1.
    int position() const;
    /// Shows a step of the list; others stay for redo and undo. False when there is no such step.
    bool jump_to(int position);

    /// What the file holds now: the current snapshot, or an earlier one whose saving took a while.
    void mark_saved(DocumentPtr saved);
    /// Whether the current snapshot is another than the one opened or last marked as saved.
    bool is_edited() const;

    /// Memory that the remembered steps add to the oldest of them, by added_bytes.
    std::size_t bytes() const;

  private:
    struct Step {
        std::string label;
        MergeKey merge_key;
        DocumentPtr document;
        std::size_t bytes = 0;  ///< what it adds to the step before
    };
    void forget_beyond_budget();

    std::vector<Step> steps_;  ///< never empty
    std::size_t current_ = 0;
    std::size_t budget_bytes_;
    bool sealed_ = true;
    DocumentPtr saved_;
};

}  // namespace patina
