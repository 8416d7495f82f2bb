#pragma once
// Student's t: how far the mean of a few samples can be off by chance [Abramowitz and Stegun, 26.7.3 and 4].

#include <cstddef>

namespace suffuse {

/// Probability that Student's t of some degrees of freedom lies within [-t, t].
double student_within(double t, std::size_t freedom);

/// The t within which Student's lies with a probability of 90 %.
double student_90(std::size_t freedom);

/// Half the width of the interval that has the next sample with 90 %, over the standard deviation of these samples.
/// Infinite for fewer than two.
double next_sample_90(std::size_t samples);

} // namespace suffuse
