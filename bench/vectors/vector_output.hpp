#pragma once

#include <string>

#include "bench/vectors/vector.hpp"

namespace tautline::bench {

/// The first member of a vector, and the first line of its text.
inline constexpr const char* vector_format = "tautline-vector-1";

/// `vector` as JSON, a line for each row, as `vector_schema_json` describes it.
[[nodiscard]] std::string vector_json(const Vector& vector);

/// The same rows as lines of words and numbers, for languages whose library reads no JSON. Comments
/// at its head say what each line has.
[[nodiscard]] std::string vector_text(const Vector& vector);

/// The JSON schema of `vector_json`.
[[nodiscard]] std::string vector_schema_json();

}  // namespace tautline::bench
