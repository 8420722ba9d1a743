// SPDX-License-Identifier: MIT
#include "document/material.h"

namespace patina {

glm::vec3 stack_bottom(Channel channel) {
    switch (channel) {
        case Channel::BaseColor:
            return glm::vec3(0.5f);
        case Channel::Roughness:
            return {0.5f, 0.0f, 0.0f};
        case Channel::Normal:
            return {0.0f, 0.0f, 1.0f};
        case Channel::Occlusion:
        case Channel::Opacity:
            return {1.0f, 0.0f, 0.0f};
        case Channel::Metalness:
        case Channel::Height:
        case Channel::Emissive:
            return glm::vec3(0.0f);
    }
    return glm::vec3(0.0f);
}

}  // namespace patina
