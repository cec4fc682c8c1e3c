// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cbvh::emulator {

/// Makes sure that umockdev's library was loaded into this process before all others, which a mocked system needs, and
/// which programs started from here then inherit: starts the program anew if it was not. To be called first in main().
void preload_umockdev(char** argv);

}  // namespace cbvh::emulator
