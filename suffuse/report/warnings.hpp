#pragma once
// A run's warnings as a reader takes them in: what many stages say alike is said once.

#include <string>
#include <vector>

namespace suffuse::report {

/// Lines "WHERE: what" that differ in WHERE and in their numbers only become one, where there are three or more of
/// them: how many stages say so, which has the largest number, and the range of each number. Others stay as they are;
/// the order is that of the first of each kind.
std::vector<std::string> merged_warnings(const std::vector<std::string>& lines);

} // namespace suffuse::report
