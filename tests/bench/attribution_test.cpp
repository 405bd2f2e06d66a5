#include "bench/attribution.hpp"

#include <gtest/gtest.h>
