// SPDX-License-Identifier: MIT
#include "editor/widgets/arithmetic.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace patina::editor {
namespace {

constexpr int kDeepestNesting = 32;

/// Recursive descent: sum = product {+- product}, product = factor {*/ factor}.
class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    std::optional<double> whole() {
        const std::optional<double> value = sum(0);
        skip_spaces();
        return position_ == text_.size() && value && std::isfinite(*value) ? value : std::nullopt;
    }

  private:
    void skip_spaces() {
        while (position_ < text_.size() && text_[position_] == ' ') ++position_;
    }
    bool take(char wanted) {
        skip_spaces();
        if (position_ >= text_.size() || text_[position_] != wanted) return false;
        ++position_;
        return true;
    }
    std::optional<double> sum(int depth) {
        std::optional<double> left = product(depth);
        while (left) {
            const bool plus = take('+');
            if (!plus && !take('-')) break;
            const std::optional<double> right = product(depth);
            if (!right) return std::nullopt;
            *left += plus ? *right : -*right;
        }
        return left;
    }
    std::optional<double> product(int depth) {
        std::optional<double> left = factor(depth);
        while (left) {
            const bool times = take('*');
            if (!times && !take('/')) break;
            const std::optional<double> right = factor(depth);
            if (!right) return std::nullopt;
            *left = times ? *left * *right : *left / *right;
        }
        return left;
    }
    std::optional<double> factor(int depth) {
        if (depth > kDeepestNesting) return std::nullopt;
        if (take('-')) {
            const std::optional<double> value = factor(depth + 1);
            return value ? std::optional(-*value) : std::nullopt;
        }
        if (take('+')) return factor(depth + 1);
        if (take('(')) {
            const std::optional<double> value = sum(depth + 1);
            return take(')') ? value : std::nullopt;
        }
        return number();
    }
    std::optional<double> number() {
        skip_spaces();
        double value = 0.0;
        const char* begin = text_.data() + position_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc{}) return std::nullopt;
        position_ += static_cast<std::size_t>(end - begin);
        return value;
    }

    std::string_view text_;
    std::size_t position_ = 0;
};

/// ASCII operators and points, without the unit at the end.
std::string plain_sum(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i).starts_with("\u2212")) {
            plain += '-';
            i += 2;
        } else {
            plain += text[i] == ',' ? '.' : text[i];
        }
    }
    const auto belongs_to_sum = [](unsigned char letter) {
        return std::isdigit(letter) != 0 ||
               std::string_view(".)(+-*/").find(static_cast<char>(letter)) !=
                   std::string_view::npos;
    };
    while (!plain.empty() && !belongs_to_sum(static_cast<unsigned char>(plain.back())))
        plain.pop_back();
    return plain;
}

}  // namespace

std::optional<double> value_of_sum(std::string_view text) {
    const std::string plain = plain_sum(text);
    return plain.empty() ? std::nullopt : Parser(plain).whole();
}

}  // namespace patina::editor
