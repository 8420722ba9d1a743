// SPDX-License-Identifier: MIT
#include "document/encoded_image.h"

#include <mutex>
#include <utility>

namespace patina {

struct EncodedImage::State {
    std::mutex mutex;
    std::shared_ptr<const Bytes> bytes;
    Make make;
    std::size_t held_bytes = 0;
};

EncodedImage::EncodedImage(std::shared_ptr<const Bytes> bytes) {
    if (!bytes) return;
    state_ = std::make_shared<State>();
    state_->bytes = std::move(bytes);
}

EncodedImage EncodedImage::when_asked(Make make, std::size_t held_bytes) {
    EncodedImage image;
    image.state_ = std::make_shared<State>();
    image.state_->make = std::move(make);
    image.state_->held_bytes = held_bytes;
    return image;
}

std::shared_ptr<const Bytes> EncodedImage::bytes() const {
    if (!state_) return nullptr;
    const std::lock_guard lock(state_->mutex);
    if (const Make make = std::exchange(state_->make, nullptr)) {
        state_->bytes = make();
        state_->held_bytes = 0;
    }
    return state_->bytes;
}

std::size_t EncodedImage::bytes_in_memory() const {
    if (!state_) return 0;
    const std::lock_guard lock(state_->mutex);
    return state_->held_bytes + (state_->bytes ? state_->bytes->size() : 0);
}

}  // namespace patina
