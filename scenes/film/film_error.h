#pragma once

#include "scenes/film/film.h"

namespace plumb {

/// The distance of a film's first layer from its expectation, as the spread of its replicates tells it. ⟨⟩ is the mean
/// over pixels and channels, v the variance of the pixel's mean m.
struct FilmError {
    double rmse = 0;  ///< √⟨v⟩
    double relative =
        0;  ///< √(⟨v⟩ / ⟨m² − v⟩): E(m² − v) is the squared truth; infinite where nothing is seen but noise
};

/// The error of the film: the roots of the MSE and the relMSE that `plumb compare` expects to find against the truth.
/// Infinite for fewer than two replicates; 0 for a film that shows no noise.
FilmError error_of(const Film& film);

}  // namespace plumb
