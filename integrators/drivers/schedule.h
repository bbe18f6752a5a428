#pragma once

#include <cstdint>
#include <functional>

namespace plumb {

/// Work in passes, counted from 0, each of which has the same number of pieces.
struct PassWork {
    std::uint32_t passes = 0;
    std::size_t pieces = 1;
    std::size_t in_flight = 2;  ///< passes that may be begun and not yet finished
    /// Begins a pass. It is called in order, one call at a time, before the first piece of the pass.
    std::function<void(std::uint32_t pass)> begin;
    /// Makes a piece. It is called in any order, on several threads at once.
    std::function<void(std::uint32_t pass, std::size_t piece)> make;
    /// Finishes a pass. It is called in order, one call at a time, when all pieces of the pass are made. Where it
    /// answers false, no later pass is finished.
    std::function<bool(std::uint32_t pass)> finish;
};

/// The number of times that a thread found nothing to do while there was work left, because as many passes were begun
/// as may be in flight.
struct ScheduleWaits {
    std::uint64_t count = 0;
};

/// Works the passes off on the threads that with_threads() allows, without a barrier between them: a thread that finds
/// no piece left in a pass begins the next. What is finished is a function of finish()'s answers alone, not of the
/// threads; passes that were begun in vain are dropped. An exception ends the work and is thrown here.
ScheduleWaits work_off(const PassWork& work);

/// The number of passes in flight, two at least, that gives each of so many threads four pieces to go on with while the
/// last piece of a pass is made, but no more than 256 MB of images of so many bytes.
std::size_t passes_in_flight(std::size_t pieces, std::size_t threads, std::size_t bytes_of_image);

}  // namespace plumb
