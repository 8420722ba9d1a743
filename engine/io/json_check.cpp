// SPDX-License-Identifier: MIT
#include "io/json_check.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/json.h"

namespace patina::io {
namespace {

// What a value costs in memory beside its text: itself with the slack of a growing array, and for
// members the node of the map with the key's string.
constexpr std::uint64_t kValueBytes = 2 * sizeof(SortedJson);
constexpr std::uint64_t kMemberBytes = sizeof(SortedJson) + sizeof(std::string) + 64;
constexpr std::uint64_t kContainerBytes = sizeof(SortedJson::object_t) + 16;

/// Builds the value event by event; every event may stop the parser by returning false.
class Builder {
  public:
    Builder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

    bool null() { return add(SortedJson(nullptr)) != nullptr; }
    bool boolean(bool value) { return add(SortedJson(value)) != nullptr; }
    bool number_integer(std::int64_t value) { return add(SortedJson(value)) != nullptr; }
    bool number_unsigned(std::uint64_t value) { return add(SortedJson(value)) != nullptr; }
    bool number_float(double value, const std::string&) {
        return add(SortedJson(value)) != nullptr;
    }
    bool string(std::string& value) {
        return take(value.size()) && add(SortedJson(std::move(value))) != nullptr;
    }
    bool binary(SortedJson::binary_t&) { return false; }  // never in text

    bool start_object(std::size_t) { return open(SortedJson::object()); }
    bool start_array(std::size_t) { return open(SortedJson::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        if (!take(kMemberBytes + name.size())) return false;
        auto& members = *open_.back()->get_ptr<SortedJson::object_t*>();
        const auto [member, is_new] = members.try_emplace(name, nullptr);
        if (!is_new)
            return refuse(fmt::format("the key \"{}\" occurs twice in one object",
                                      quoted_for_message(name, 60)));
        member_ = &member->second;
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& ex) {
        // 406: a number beyond the range of double.
        const std::string_view what =
            ex.id == 406 ? "a number that is too large" : "not well-formed JSON in UTF-8";
        return refuse(fmt::format("{}: {}", location(position), what));
    }

    const std::string& fault() const { return fault_; }
    SortedJson take_root() { return std::move(root_); }

  private:
    /// Puts a value where it belongs; null when it would be beyond the limit.
    SortedJson* add(SortedJson&& value) {
        if (!take(kValueBytes)) return nullptr;
        if (open_.empty()) return &(root_ = std::move(value));
        if (open_.back()->is_array()) {
            auto& elements = *open_.back()->get_ptr<SortedJson::array_t*>();
            return &elements.emplace_back(std::move(value));
        }
        return &(*member_ = std::move(value));
    }
    bool open(SortedJson&& value) {
        if (open_.size() >= static_cast<std::size_t>(limits_.depth))
            return refuse(fmt::format("nested deeper than {} levels", limits_.depth));
        if (!take(kContainerBytes)) return false;
        // Pointers to parents stay valid: an array does not grow while its last element is open.
        SortedJson* const added = add(std::move(value));
        if (added) open_.push_back(added);
        return added != nullptr;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    bool take(std::uint64_t bytes) {
        taken_ += bytes;
        if (taken_ <= limits_.memory_bytes) return true;
        return refuse(fmt::format("needs more than the limit of {} MiB of memory when parsed",
                                  limits_.memory_bytes >> 20));
    }
    bool refuse(std::string fault) {
        if (fault_.empty()) fault_ = std::move(fault);
        return false;
    }
    std::string location(std::size_t position) const {
        const auto before = text_.substr(0, std::min(position, text_.size()));
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const auto line_start = before.rfind('\n');
        const auto column =
            line_start == std::string_view::npos ? before.size() : before.size() - line_start - 1;
        return fmt::format("line {}, column {}", line, column);
    }

    std::string_view text_;
    JsonLimits limits_;
    SortedJson root_;
    std::vector<SortedJson*> open_;
    SortedJson* member_ = nullptr;
    std::uint64_t taken_ = 0;
    std::string fault_;
};

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits) {
    Builder builder(text, limits);
    if (!SortedJson::sax_parse(text.begin(), text.end(), &builder))
        return failure("{}", builder.fault());
    return builder.take_root();
}

}  // namespace patina::io
