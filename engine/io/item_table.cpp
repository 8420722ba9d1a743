// SPDX-License-Identifier: MIT
#include "io/item_table.h"

#include <algorithm>
#include <cassert>

namespace patina::io {

ItemTable::ItemTable(Json& items, const std::vector<bool>& own)
    : items_(&items), first_new_(static_cast<int>(items.size())), kept_(items.size(), true) {
    assert(own.size() == items.size());
    first_own_ = first_new_;
    while (first_own_ > 0 && own[static_cast<std::size_t>(first_own_ - 1)]) --first_own_;
    std::fill(kept_.begin() + first_own_, kept_.end(), false);
}

int ItemTable::add(Json item) {
    items_->push_back(std::move(item));
    kept_.push_back(false);
    return size() - 1;
}

void ItemTable::keep(int index) {
    if (index >= 0 && index < size()) kept_[static_cast<std::size_t>(index)] = true;
}

bool ItemTable::is_kept(int index) const {
    return index >= 0 && index < size() && kept_[static_cast<std::size_t>(index)];
}

std::vector<int> ItemTable::compact() {
    const auto count = static_cast<int>(std::count(kept_.begin(), kept_.end(), true));
    std::vector<int> moved(kept_.size(), -1);
    std::vector<int> homeless;
    // An old item stays where it is unless the array becomes too short for it.
    std::vector<bool> taken(static_cast<std::size_t>(count), false);
    for (int i = 0; i < size(); ++i) {
        if (!is_kept(i)) continue;
        if (i < first_new_ && i < count) {
            moved[static_cast<std::size_t>(i)] = i;
            taken[static_cast<std::size_t>(i)] = true;
        } else {
            homeless.push_back(i);
        }
    }
    int place = 0;
    for (const int item : homeless) {
        while (taken[static_cast<std::size_t>(place)]) ++place;
        moved[static_cast<std::size_t>(item)] = place++;
    }
    Json compacted = Json::array();
    compacted.get_ref<Json::array_t&>().resize(static_cast<std::size_t>(count));
    for (int i = 0; i < size(); ++i)
        if (const int to = moved[static_cast<std::size_t>(i)]; to >= 0)
            compacted[static_cast<std::size_t>(to)] = std::move((*this)[i]);
    *items_ = std::move(compacted);
    return moved;
}

}  // namespace patina::io
