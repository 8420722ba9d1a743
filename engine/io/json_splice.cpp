// SPDX-License-Identifier: MIT
#include "io/json_splice.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace patina::io {
namespace {

struct TextEdit {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::string text;
};

/// How the children of a container are laid out.
struct Layout {
    std::string separator = ",";  ///< between two children, comma included
    std::string opening;          ///< between the bracket and the first child
    std::string closing;          ///< between the last child and the bracket
    std::string indent;           ///< of a child's line
    bool lines = false;           ///< children stand on lines of their own
};

std::string dumped(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_container(const Json& value) {
    return value.is_object() || value.is_array();
}

/// Finds out how a text is laid out, and lays out new values in the same way.
class Style {
  public:
    explicit Style(const JsonSpans& spans) : spans_(spans) {
        const int first = spans.node(0).first_child;
        if (first < 0) return;
        const std::string_view lead =
            between(spans.node(0).value.begin + 1, spans.node(first).begin());
        lines_ = lead.find('\n') != std::string_view::npos;
        if (lines_) unit_ = after_last_line_break(lead);
        if (lines_ && unit_.empty()) unit_ = "  ";
        const JsonNode& node = spans.node(first);
        if (node.key.end > node.key.begin) colon_ = between(node.key.end, node.value.begin);
    }

    Layout layout_of(int container) const {
        const std::vector<int> children = spans_.children(container);
        return children.empty() ? layout_of_empty(container)
                                : layout_of_filled(container, children);
    }

    /// A member (`key` not empty) or an element, as it stands in a container with that layout.
    std::string item(const std::string* key, const Json& value, const Layout& layout) const {
        const std::string text = laid_out(value, layout.indent, layout.lines);
        return key ? dumped(Json(*key)) + colon_ + text : text;
    }
    std::string laid_out(const Json& value, const std::string& indent, bool lines) const {
        std::string text;
        append(value, indent, lines, text);
        return text;
    }

  private:
    std::string_view between(std::uint32_t begin, std::uint32_t end) const {
        return spans_.text_of({begin, end});
    }
    static std::string after_last_line_break(std::string_view separator) {
        const std::string_view line = separator.substr(separator.rfind('\n') + 1);
        // Where commas lead the lines, the indentation ends before them.
        return std::string(line.substr(0, std::min(line.find_first_not_of(" \t\r"), line.size())));
    }

    Layout layout_of_filled(int container, const std::vector<int>& children) const {
        const JsonNode& first = spans_.node(children.front());
        const std::string_view lead =
            between(spans_.node(container).value.begin + 1, first.begin());
        Layout layout;
        layout.separator =
            children.size() > 1
                ? std::string(between(first.value.end, spans_.node(children[1]).begin()))
                : "," + std::string(lead);
        layout.lines = layout.separator.find('\n') != std::string::npos;
        if (layout.lines) layout.indent = after_last_line_break(layout.separator);
        return layout;
    }

    Layout layout_of_empty(int container) const {
        Layout layout;
        if (!lines_) return layout;
        const std::string outer = line_indent(spans_.node(container).value.begin);
        layout.lines = true;
        layout.indent = outer + unit_;
        layout.opening = "\n" + layout.indent;
        layout.separator = "," + layout.opening;
        layout.closing = "\n" + outer;
        return layout;
    }

    /// The white space at the start of the line that `position` is on.
    std::string line_indent(std::uint32_t position) const {
        const std::string_view before = std::string_view(spans_.text()).substr(0, position);
        const std::size_t line = before.rfind('\n') + 1;  // 0 where there is no line break
        const std::size_t end = std::min(before.find_first_not_of(" \t", line), before.size());
        return std::string(before.substr(line, end - line));
    }

    void append(const Json& value, const std::string& indent, bool lines, std::string& out) const {
        const bool spread =
            lines && is_container(value) && !value.empty() &&
            (value.is_object() || std::any_of(value.begin(), value.end(), is_container));
        if (!is_container(value) || value.empty()) {
            out += dumped(value);
            return;
        }
        const std::string inner = indent + unit_;
        out += value.is_object() ? '{' : '[';
        bool first = true;
        for (const auto& [key, child] : value.items()) {
            if (!first) out += lines && !spread ? ", " : ",";
            first = false;
            if (spread) out += "\n" + inner;
            if (value.is_object()) out += dumped(Json(key)) + colon_;
            append(child, inner, lines, out);
        }
        if (spread) out += "\n" + indent;
        out += value.is_object() ? '}' : ']';
    }

    const JsonSpans& spans_;
    bool lines_ = false;
    std::string unit_;
    std::string colon_ = ":";
};

class Splicer {
  public:
    explicit Splicer(const JsonSpans& spans) : spans_(spans), style_(spans) {}

    Status apply(const JsonChange& change) {
        if (const auto node = spans_.find(change.pointer)) {
            if (change.value) {
                make(*node, *change.value);
                return {};
            }
            const int parent = spans_.node(*node).parent;
            if (parent < 0) return failure("the root of a JSON text cannot be removed");
            of(parent).removed.push_back(*node);
            return {};
        }
        return change.value ? add(change.pointer, *change.value) : Status{};
    }

    std::string finish() {
        for (const auto& [container, changes] : children_) rewrite(container, changes);
        // An insertion goes before a removal that begins at the same place.
        std::stable_sort(edits_.begin(), edits_.end(), [](const TextEdit& a, const TextEdit& b) {
            return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
        });
        std::string out;
        std::uint32_t done = 0;
        for (const TextEdit& edit : edits_) {
            out += spans_.text_of({done, edit.begin});
            out += edit.text;
            done = edit.end;
        }
        out += spans_.text_of({done, static_cast<std::uint32_t>(spans_.text().size())});
        return out;
    }

  private:
    struct Addition {
        std::optional<std::string> key;
        Json value;
    };
    struct ChildChanges {
        std::vector<int> removed;  ///< children, in any order
        std::vector<Addition> added;
    };

    ChildChanges& of(int container) { return children_[container]; }

    Status add(const std::string& pointer, const Json& value) {
        const std::size_t slash = pointer.rfind('/');
        if (slash == std::string::npos) return failure("'{}' is no JSON pointer", pointer);
        const auto parent = spans_.find(std::string_view(pointer).substr(0, slash));
        if (!parent) return failure("the JSON text has nothing at '{}'", pointer.substr(0, slash));
        switch (spans_.node(*parent).kind) {
            case JsonKind::Object:
                // Member names in use have no ~ or / in them.
                of(*parent).added.push_back({pointer.substr(slash + 1), value});
                return {};
            case JsonKind::Array:
                of(*parent).added.push_back({std::nullopt, value});
                return {};
            default:
                return failure("the JSON text has no container at '{}'", pointer.substr(0, slash));
        }
    }

    /// Makes the value of a node mean `wanted`.
    void make(int node, const Json& wanted) {
        const JsonKind kind = spans_.node(node).kind;
        if (kind == JsonKind::Object && wanted.is_object()) return make_object(node, wanted);
        if (kind == JsonKind::Array && wanted.is_array()) return make_array(node, wanted);
        const bool container = kind == JsonKind::Object || kind == JsonKind::Array;
        const TextSpan span = spans_.node(node).value;
        if (!container && Json::parse(spans_.text_of(span), nullptr, false) == wanted) return;
        const int parent = spans_.node(node).parent;
        const Layout around = parent < 0 ? Layout{} : style_.layout_of(parent);
        edits_.push_back(
            {span.begin, span.end, style_.laid_out(wanted, around.indent, around.lines)});
    }

    void make_object(int node, const Json& wanted) {
        std::map<std::string, int> present;  // of a name that occurs twice the last one counts
        for (const int child : spans_.children(node)) {
            const std::string key = spans_.key_of(child);
            present[key] = child;
            if (!wanted.contains(key)) of(node).removed.push_back(child);
        }
        for (const auto& [key, value] : wanted.items()) {
            const auto found = present.find(key);
            if (found == present.end())
                of(node).added.push_back({key, value});
            else
                make(found->second, value);
        }
    }

    void make_array(int node, const Json& wanted) {
        const std::vector<int> elements = spans_.children(node);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (i < wanted.size())
                make(elements[i], wanted[i]);
            else
                of(node).removed.push_back(elements[i]);
        }
        for (std::size_t i = elements.size(); i < wanted.size(); ++i)
            of(node).added.push_back({std::nullopt, wanted[i]});
    }

    void rewrite(int container, const ChildChanges& changes) {
        if (changes.removed.empty() && changes.added.empty()) return;
        const Layout layout = style_.layout_of(container);
        std::string added;
        for (const Addition& addition : changes.added) {
            if (!added.empty()) added += layout.separator;
            added += style_.item(addition.key ? &*addition.key : nullptr, addition.value, layout);
        }
        std::vector<int> children = spans_.children(container);
        const auto gone = [&](int child) {
            return std::find(changes.removed.begin(), changes.removed.end(), child) !=
                   changes.removed.end();
        };
        const auto last_kept = std::find_if_not(children.rbegin(), children.rend(), gone);
        if (last_kept == children.rend()) return refill(container, children, layout, added);
        if (!added.empty()) {
            const std::uint32_t at = spans_.node(*last_kept).value.end;
            edits_.push_back({at, at, layout.separator + added});
        }
        remove(children, gone);
    }

    /// Puts `added` in the place of all children.
    void refill(int container, const std::vector<int>& children, const Layout& layout,
                const std::string& added) {
        const TextSpan span = spans_.node(container).value;
        if (added.empty()) {
            edits_.push_back({span.begin + 1, span.end - 1, ""});
        } else if (children.empty()) {
            edits_.push_back(
                {span.begin + 1, span.end - 1, layout.opening + added + layout.closing});
        } else {
            edits_.push_back({spans_.node(children.front()).begin(),
                              spans_.node(children.back()).value.end, added});
        }
    }

    /// Removes children, of which at least one stays, each with the separator that it needs no
    /// more.
    template <typename Gone>
    void remove(const std::vector<int>& children, const Gone& gone) {
        const auto first_kept = std::find_if_not(children.begin(), children.end(), gone);
        if (first_kept != children.begin())
            edits_.push_back(
                {spans_.node(children.front()).begin(), spans_.node(*first_kept).begin(), ""});
        for (auto child = first_kept + 1; child < children.end(); ++child)
            if (gone(*child))
                edits_.push_back(
                    {spans_.node(*(child - 1)).value.end, spans_.node(*child).value.end, ""});
    }

    const JsonSpans& spans_;
    Style style_;
    std::map<int, ChildChanges> children_;
    std::vector<TextEdit> edits_;
};

}  // namespace

Result<std::string> spliced(const JsonSpans& spans, const std::vector<JsonChange>& changes) {
    Splicer splicer(spans);
    for (const JsonChange& change : changes)
        if (const Status ok = splicer.apply(change); !ok) return passed_on(ok);
    return splicer.finish();
}

Json parsed_at(const JsonSpans& spans, std::string_view pointer) {
    const auto node = spans.find(pointer);
    if (!node) return nullptr;
    Json value = Json::parse(spans.value_text(*node), nullptr, false);
    return value.is_discarded() ? Json(nullptr) : value;
}

Json json_number(float value) {
    std::array<char, 64> text = {};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    double number = value;
    std::from_chars(text.data(), written.ptr, number);
    if (number == std::nearbyint(number) && std::abs(number) < 1e9)
        return static_cast<std::int64_t>(number);
    return number;
}

}  // namespace patina::io
