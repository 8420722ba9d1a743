// SPDX-License-Identifier: MIT
#pragma once

/// Where each member and element of a JSON text lies, so that a save can replace some of them and
/// copy the rest byte for byte.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace patina::io {

/// Bytes [begin, end) of the text.
struct TextSpan {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const TextSpan&) const = default;
};

enum class JsonKind : std::uint8_t { Object, Array, String, Number, Literal };

/// A value of the text. Nodes are known by their index in JsonSpans::nodes(); -1 is none.
struct JsonNode {
    TextSpan key;    ///< of an object's member, with its quotes; empty otherwise
    TextSpan value;  ///< without space around it
    int parent = -1;
    int first_child = -1;
    int next_sibling = -1;
    JsonKind kind = JsonKind::Literal;

    /// Where the member or element begins: at its key, where it has one.
    std::uint32_t begin() const { return key.end > key.begin ? key.begin : value.begin; }
};

class JsonSpans {
  public:
    /// Scans one JSON value, up to 4 GiB of text and 64 levels deep, in one pass without recursion.
    /// Spans are exact for every valid text; what is no JSON is mostly, but not always, refused.
    /// @param text  copied
    static Result<JsonSpans> scan(std::string text);

    const std::string& text() const { return text_; }
    /// In the order of the text; the root is the first.
    const std::vector<JsonNode>& nodes() const { return nodes_; }
    const JsonNode& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }

    std::string_view text_of(TextSpan span) const {
        return std::string_view(text_).substr(span.begin, span.end - span.begin);
    }
    std::string_view value_text(int index) const { return text_of(node(index).value); }
    std::vector<int> children(int index) const;
    /// The unescaped key of a member.
    std::string key_of(int index) const;
    /// The member of an object by its unescaped key; of several the last, as parsers take it.
    std::optional<int> member(int object, std::string_view key) const;
    /// By JSON pointer (RFC 6901), such as "/materials/0/name"; "" is the root.
    std::optional<int> find(std::string_view pointer) const;

  private:
    std::string text_;
    std::vector<JsonNode> nodes_;
};

}  // namespace patina::io
