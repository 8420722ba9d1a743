// SPDX-License-Identifier: MIT
#include <fmt/format.h>

int main() {
    fmt::print("patina {}\n", PATINA_VERSION);
    return 0;
}
