// Abseil's texts, as far as Principia's polynomials ask for them when they print themselves.
#pragma once
#include <sstream>
#include <string>

namespace absl {

template<typename... T>
std::string StrCat(T const&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

template<typename... T>
void StrAppend(std::string* text, T const&... parts) {
  *text += StrCat(parts...);
}

template<typename List>
std::string StrJoin(List const& list, std::string const& between) {
  std::string text;
  for (auto const& part : list) {
    text += (text.empty() ? "" : between) + part;
  }
  return text;
}

}  // namespace absl
