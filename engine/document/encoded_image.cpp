// SPDX-License-Identifier: MIT
#include "document/encoded_image.h"

#include <mutex>
#include <utility>

namespace patina {

struct EncodedImage::State {
    std::mutex mutex;
    std::shared_ptr<const Bytes> bytes;
    Make make;
};

EncodedImage::EncodedImage(std::shared_ptr<const Bytes> bytes) {
    if (!bytes) return;
    state_ = std::make_shared<State>();
    state_->bytes = std::move(bytes);
}

EncodedImage EncodedImage::when_asked(Make make) {
    EncodedImage image;
    image.state_ = std::make_shared<State>();
    image.state_->make = std::move(make);
    return image;
}

std::shared_ptr<const Bytes> EncodedImage::bytes() const {
    if (!state_) return nullptr;
    const std::lock_guard lock(state_->mutex);
    if (const Make make = std::exchange(state_->make, nullptr)) state_->bytes = make();
    return state_->bytes;
}

std::size_t EncodedImage::bytes_in_memory() const {
    if (!state_) return 0;
    const std::lock_guard lock(state_->mutex);
    return state_->bytes ? state_->bytes->size() : 0;
}

}  // namespace patina
