// SPDX-License-Identifier: MIT
#pragma once

/// The bytes of an image file, as an image travels with its document.

#include <functional>
#include <memory>

#include "core/files.h"

namespace patina {

/// Bytes that are there, or that are made when they are first asked for: most images that are read
/// from formats which glTF does not carry are looked at long before they are saved, or never are.
/// Cheap to copy; copies share the bytes. Thread-safe.
class EncodedImage {
  public:
    /// Gives null where the bytes could not be made.
    using Make = std::function<std::shared_ptr<const Bytes>()>;

    /// None.
    EncodedImage() = default;
    EncodedImage(std::shared_ptr<const Bytes> bytes);
    /// `make` is called once at most and let go of then.
    static EncodedImage when_asked(Make make);

    /// Whether there are any.
    explicit operator bool() const { return state_ != nullptr; }
    /// Null where there are none or they could not be made.
    std::shared_ptr<const Bytes> bytes() const;
    /// 0 for what is not made: pixels count where they are decoded.
    std::size_t bytes_in_memory() const;

  private:
    struct State;
    std::shared_ptr<State> state_;
};

}  // namespace patina
