// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

#include "gl/headless_context.h"

namespace patina {

/// A test with an OpenGL context of its own, in which any OpenGL error fails the test.
class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        Result<gl::HeadlessContext> made = gl::HeadlessContext::make(
            [](std::string_view message) { ADD_FAILURE() << "OpenGL: " << message; });
        ASSERT_TRUE(made) << made.error().message;
        context_.emplace(std::move(*made));
    }
    void TearDown() override {
        if (context_) context_->debug_output().poll();
    }

  private:
    std::optional<gl::HeadlessContext> context_;
};

}  // namespace patina
