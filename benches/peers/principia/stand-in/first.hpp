// Read before every file: Principia writes `nullptr_t` without its namespace, which GCC's library does not have.
#pragma once
#include <cstddef>
using std::nullptr_t;
