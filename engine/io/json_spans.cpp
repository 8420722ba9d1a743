// SPDX-License-Identifier: MIT
#include "io/json_spans.h"

#include <array>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

namespace patina::io {
namespace {

constexpr std::size_t kMaxDepth = 64;

bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

/// Characters of numbers, true, false and null.
bool is_word(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '+' || c == '.' ||
           c == 'E';
}

class Scanner {
  public:
    Scanner(std::string_view text, std::vector<JsonNode>& nodes) : text_(text), nodes_(nodes) {}

    Status scan() {
        do {
            const Status ok = containers_.empty() ? read_value({}) : read_next_in_container();
            if (!ok) return ok;
        } while (!containers_.empty());
        skip_space();
        return at_ == text_.size() ? Status{} : fault("text after the end of the value");
    }

  private:
    struct Container {
        int node = 0;
        int last_child = -1;
    };

    tl::unexpected<Error> fault(std::string_view what) const {
        return failure("JSON, byte {}: {}", at_, what);
    }

    void skip_space() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    }
    bool at(char c) const { return at_ < text_.size() && text_[at_] == c; }
    std::uint32_t position() const { return static_cast<std::uint32_t>(at_); }

    bool skip_string() {
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\\') {
                ++at_;
            } else if (text_[at_] == '"') {
                ++at_;
                return true;
            }
        }
        return false;
    }

    int add_node(TextSpan key, JsonKind kind) {
        const int index = static_cast<int>(nodes_.size());
        JsonNode node;
        node.key = key;
        node.kind = kind;
        node.value.begin = position();
        if (!containers_.empty()) {
            Container& parent = containers_.back();
            node.parent = parent.node;
            int& link = parent.last_child < 0 ? nodes_[as_index(parent.node)].first_child
                                              : nodes_[as_index(parent.last_child)].next_sibling;
            link = index;
            parent.last_child = index;
        }
        nodes_.push_back(node);
        return index;
    }
    static std::size_t as_index(int node) { return static_cast<std::size_t>(node); }

    Status read_value(TextSpan key) {
        skip_space();
        if (at_ >= text_.size()) return fault("the text ends where a value is expected");
        switch (text_[at_]) {
            case '{':
                return open(key, JsonKind::Object);
            case '[':
                return open(key, JsonKind::Array);
            case '"': {
                const int node = add_node(key, JsonKind::String);
                if (!skip_string()) return fault("a string has no end");
                nodes_[as_index(node)].value.end = position();
                return {};
            }
            default:
                return read_word(key);
        }
    }

    Status read_word(TextSpan key) {
        const char first = text_[at_];
        const bool number = first == '-' || (first >= '0' && first <= '9');
        const int node = add_node(key, number ? JsonKind::Number : JsonKind::Literal);
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        if (position() == nodes_[as_index(node)].value.begin) return fault("not a value");
        nodes_[as_index(node)].value.end = position();
        return {};
    }

    Status open(TextSpan key, JsonKind kind) {
        if (containers_.size() >= kMaxDepth) return fault("more than 64 levels deep");
        const int node = add_node(key, kind);
        containers_.push_back({.node = node});
        ++at_;
        return {};
    }

    void close() {
        ++at_;
        nodes_[as_index(containers_.back().node)].value.end = position();
        containers_.pop_back();
    }

    /// After the opening bracket or a child: closes the container or reads one more child.
    Status read_next_in_container() {
        const Container container = containers_.back();
        const bool object = nodes_[as_index(container.node)].kind == JsonKind::Object;
        skip_space();
        if (at(object ? '}' : ']')) {
            close();
            return {};
        }
        if (container.last_child >= 0) {
            if (!at(',')) return fault("a comma or a closing bracket is missing");
            ++at_;
        }
        return object ? read_member() : read_value({});
    }

    Status read_member() {
        skip_space();
        if (!at('"')) return fault("a member's name is missing");
        TextSpan key = {.begin = position()};
        if (!skip_string()) return fault("a string has no end");
        key.end = position();
        skip_space();
        if (!at(':')) return fault("a colon is missing");
        ++at_;
        return read_value(key);
    }

    std::string_view text_;
    std::vector<JsonNode>& nodes_;
    std::vector<Container> containers_;
    std::size_t at_ = 0;
};

/// One step of a JSON pointer with ~1 and ~0 taken back.
std::string unescaped_step(std::string_view step) {
    std::string plain;
    for (std::size_t i = 0; i < step.size(); ++i) {
        const bool escape = step[i] == '~' && i + 1 < step.size();
        plain += !escape ? step[i] : step[++i] == '1' ? '/' : '~';
    }
    return plain;
}

}  // namespace

Result<JsonSpans> JsonSpans::scan(std::string text) {
    if (text.size() >= std::numeric_limits<std::uint32_t>::max())
        return failure("JSON of {} bytes is more than the limit of 4 GiB", text.size());
    JsonSpans spans;
    spans.text_ = std::move(text);
    if (const Status ok = Scanner(spans.text_, spans.nodes_).scan(); !ok) return passed_on(ok);
    return spans;
}

std::vector<int> JsonSpans::children(int index) const {
    std::vector<int> found;
    for (int child = node(index).first_child; child >= 0; child = node(child).next_sibling)
        found.push_back(child);
    return found;
}

std::string JsonSpans::key_of(int index) const {
    const std::string_view quoted = text_of(node(index).key);
    if (quoted.find('\\') == std::string_view::npos)
        return quoted.empty() ? std::string() : std::string(quoted.substr(1, quoted.size() - 2));
    const auto parsed = nlohmann::json::parse(quoted, nullptr, false);
    return parsed.is_string() ? parsed.get<std::string>() : std::string(quoted);
}

std::optional<int> JsonSpans::member(int object, std::string_view key) const {
    std::optional<int> found;
    if (node(object).kind != JsonKind::Object) return found;
    for (int child = node(object).first_child; child >= 0; child = node(child).next_sibling)
        if (key_of(child) == key) found = child;
    return found;
}

std::optional<int> JsonSpans::find(std::string_view pointer) const {
    int at = 0;
    while (!pointer.empty()) {
        if (pointer.front() != '/') return std::nullopt;
        const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
        const std::string step = unescaped_step(pointer.substr(1, end - 1));
        pointer.remove_prefix(end);
        if (node(at).kind == JsonKind::Object) {
            const auto found = member(at, step);
            if (!found) return std::nullopt;
            at = *found;
        } else {
            std::size_t index = 0;
            const auto [rest, error] =
                std::from_chars(step.data(), step.data() + step.size(), index);
            const std::vector<int> elements = children(at);
            if (error != std::errc() || rest != step.data() + step.size()) return std::nullopt;
            if (index >= elements.size()) return std::nullopt;
            at = elements[index];
        }
    }
    return at;
}

}  // namespace patina::io
