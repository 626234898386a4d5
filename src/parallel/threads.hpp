// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// Sets how many threads all runs of this process use; 0 = every core.
void set_threads(int threads);

}  // namespace kerf
