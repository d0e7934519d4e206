// Abseil's checks and logs, as far as Principia's solver asks for them: a check that fails ends the program, nothing is printed,
// and the checks of debug builds are compiled and not made, as with NDEBUG.
#pragma once
#include <cstdlib>

namespace stand_in {

struct Silent {
  template<typename T>
  Silent const& operator<<(T const&) const {
    return *this;
  }
};

struct Fatal {
  template<typename T>
  Fatal const& operator<<(T const&) const {
    return *this;
  }
  [[noreturn]] ~Fatal() {
    std::abort();
  }
};

// Makes of a stream what may stand beside `(void)0`.
struct Ends {
  template<typename T>
  void operator&(T const&) const {}
};

}  // namespace stand_in

#define CHECK(condition) (condition) ? (void)0 : ::stand_in::Ends() & ::stand_in::Fatal()
#define CHECK_EQ(a, b) CHECK((a) == (b))
#define CHECK_NE(a, b) CHECK((a) != (b))
#define CHECK_LE(a, b) CHECK((a) <= (b))
#define CHECK_LT(a, b) CHECK((a) < (b))
#define CHECK_GE(a, b) CHECK((a) >= (b))
#define CHECK_GT(a, b) CHECK((a) > (b))
#define CHECK_NOTNULL(pointer) (pointer)

#define DCHECK(condition) true || (condition) ? (void)0 : ::stand_in::Ends() & ::stand_in::Silent()
#define DCHECK_EQ(a, b) DCHECK((a) == (b))
#define DCHECK_NE(a, b) DCHECK((a) != (b))
#define DCHECK_LE(a, b) DCHECK((a) <= (b))
#define DCHECK_LT(a, b) DCHECK((a) < (b))
#define DCHECK_GE(a, b) DCHECK((a) >= (b))
#define DCHECK_GT(a, b) DCHECK((a) > (b))

#define LOG(severity) LOG_##severity
#define LOG_FATAL ::stand_in::Fatal()
#define LOG_ERROR ::stand_in::Silent()
#define LOG_WARNING ::stand_in::Silent()
#define LOG_INFO ::stand_in::Silent()
#define LOG_IF(severity, condition) !(condition) ? (void)0 : ::stand_in::Ends() & LOG(severity)
#define DLOG(severity) ::stand_in::Silent()
