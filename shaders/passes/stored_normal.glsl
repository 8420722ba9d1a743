// SPDX-License-Identifier: MIT
// The length of the G-buffer's normal, whose direction is all that is needed of it, holds what the
// horizon leaves of mirrored light. Half floats are as exact for short vectors.

const float LEAST_STORED_LENGTH = 1.0 / 64.0;  // so that the direction is never lost

float stored_length(float horizon) {
    return max(horizon, LEAST_STORED_LENGTH);
}

/// 1 is exact, though the rounded vector is not quite that long.
float stored_horizon(float length) {
    return length > 0.998 ? 1.0 : length;
}
