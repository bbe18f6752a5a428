#include "integrators/drivers/render.h"

#include <deque>
#include <mutex>

#include "core/parallel.h"
#include "integrators/drivers/schedule.h"

namespace plumb {

namespace {

std::size_t bytes_of_image(const FilmRegion& crop, const std::vector<FilmLayer>& layers) {
    std::size_t channels = 0;
    for (const FilmLayer& layer : layers) channels += layer.channels.size();
    return static_cast<std::size_t>(crop.width) * static_cast<std::size_t>(crop.height) * channels * sizeof(ExactSum);
}

std::uint32_t count_of_passes(const RenderSettings& settings) {
    if (settings.first_pass >= settings.passes) return 0;
    return (settings.passes - 1 - settings.first_pass) / settings.pass_step + 1;
}

// Says how far the render is, one call at a time.
class Teller {
public:
    using GoOn = std::function<bool(const RenderProgress&)>;

    Teller(const GoOn& go_on, std::uint64_t total) : go_on_(go_on), progress_{0, total} {}

    bool tell(std::uint64_t more_done) {
        const std::lock_guard lock(mutex_);
        progress_.done += more_done;
        return !go_on_ || go_on_(progress_);
    }

private:
    const GoOn& go_on_;
    RenderProgress progress_;
    std::mutex mutex_;
};

// The images of the passes that are begun and not finished.
class ImagesInFlight {
public:
    void begin(const FilmRegion& crop, const std::vector<FilmLayer>& layers) {
        const std::lock_guard lock(mutex_);
        images_.emplace_back(crop, layers);
    }
    PassImage& of(std::uint32_t pass) {
        const std::lock_guard lock(mutex_);
        return images_[pass - finished_];
    }
    void drop_first() {
        const std::lock_guard lock(mutex_);
        images_.pop_front();
        ++finished_;
    }

private:
    std::deque<PassImage> images_;
    std::uint32_t finished_ = 0;
    std::mutex mutex_;
};

}  // namespace

Rendered render(const RenderJob& job, const std::function<bool(const RenderProgress&)>& go_on) {
    const RenderSettings& settings = job.settings;
    check_crop(settings.crop, job.scene.sensor().film());
    const Driver& driver = *job.driver;
    const std::size_t pieces = driver.pieces(job), threads = static_cast<std::size_t>(hardware_threads());
    const std::uint32_t passes = count_of_passes(settings);
    const std::vector<FilmLayer> layers = render_layers(job);
    Rendered result{Film({settings.crop.width, settings.crop.height}, layers)};
    Teller teller(go_on, std::uint64_t{passes} * pieces);
    ImagesInFlight images;
    work_off({.passes = passes,
              .pieces = pieces,
              .in_flight = passes_in_flight(pieces, threads, bytes_of_image(settings.crop, layers)),
              .begin = [&](std::uint32_t) { images.begin(settings.crop, layers); },
              .make =
                  [&](std::uint32_t pass, std::size_t piece) {
                      driver.make(job, settings.first_pass + pass * settings.pass_step, piece, images.of(pass));
                      teller.tell(1);
                  },
              .finish =
                  [&](std::uint32_t pass) {
                      PassImage& image = images.of(pass);
                      result.film.add(image.pixels());
                      result.rays += image.rays();
                      images.drop_first();
                      return teller.tell(0);
                  }});
    return result;
}

Rendered render(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                const std::function<bool(const RenderProgress&)>& go_on) {
    return render(job_of(scene, estimator, settings), go_on);
}

}  // namespace plumb
