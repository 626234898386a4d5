// SPDX-License-Identifier: Apache-2.0
// All that a program needs that links to libkerf.so: cases as plain data, read, checked and
// written; runs with their files, or the bare simulation; frames, fields and balance. docs/cpp.md
// shows how it is used.
#pragma once

#include "core/error.hpp"
#include "core/version.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "library/run.hpp"
#include "model/case.hpp"
