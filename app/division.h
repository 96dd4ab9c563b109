#pragma once

namespace brewster {

/// What a picture still errs by after so much work of one kind: of the photons that made its bins, or of its draws.
struct Effort {
    double seconds = 0;  ///< spent so far
    double error = 0;    ///< squared relative error that is left
};

/// Seconds for both kinds.
struct Division {
    double photons = 0, draws = 0;
    double total() const { return photons + draws; }
};

/// The squared error after other than the known seconds: it falls with photons^-0.6 (cells shrink while photons come) and
/// with draws^-1.2 (they are evenly spread), which is what the pictures' errors do (tests/bench/README.md).
double expected_error(const Effort& photons, const Effort& draws, const Division& division);

/// The division of so many seconds that leaves the smallest error: the time of each kind is in proportion to its share of
/// the error, times its power. A kind without error gets none.
Division divided(const Effort& photons, const Effort& draws, double seconds);

/// The shortest division that is expected to end at the squared error `target`.
Division division_to(const Effort& photons, const Effort& draws, double target);

}  // namespace brewster
