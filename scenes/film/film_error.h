#pragma once

#include "scenes/film/film.h"

namespace plumb {

/// The distance of a film's first layer from its expectation, as the spread of its replicates tells it. ⟨⟩ is the mean
/// over pixels and channels, v the variance of the pixel's mean m.
struct FilmError {
    double rmse = 0;  ///< √⟨v⟩
    double relative =
        0;  ///< √(⟨v⟩ / ⟨m² − v⟩): E(m² − v) is the squared truth; infinite where nothing is seen but noise
    std::vector<double> of_means = {};  ///< channel by channel, the standard error of the mean over all pixels
};

/// The error of the film: the roots of the MSE and the relMSE that `plumb compare` expects to find against the truth.
/// Infinite for fewer than two replicates; 0 for a film that shows no noise.
FilmError error_of(const Film& film);

/// The relative standard error of ⟨v⟩ of two films together, which are of the same picture and independent: by how much
/// the two differ in each pixel. k rare spikes that carry all of v make it 1/√k, however regular the rest is. 0 where
/// neither shows noise, infinite where one has fewer than two replicates.
double error_of_variance(const Film& one, const Film& other);

}  // namespace plumb
