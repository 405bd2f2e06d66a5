#pragma once

// The order matters, and the second header has no guard against C++ of its own.
#include <chipmunk/chipmunk.h>
extern "C" {
#include <chipmunk/chipmunk_private.h>
}
