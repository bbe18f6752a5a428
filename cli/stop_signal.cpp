#include "cli/stop_signal.h"

#include <atomic>
#include <csignal>

namespace plumb::cli {
namespace {

std::atomic<int> noted = 0;  // any thread may take the signal
static_assert(std::atomic<int>::is_always_lock_free);

void note(int signal) {
    noted = signal;
}

void handle(int signal) {
    struct sigaction before {};
    struct sigaction ours {};
    ours.sa_handler = note;
    ours.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(signal, &ours, &before);
    if (before.sa_handler == SIG_IGN) sigaction(signal, &before, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
    noted = 0;
    handle(SIGINT);
    handle(SIGTERM);
}

StopSignal::~StopSignal() {
    for (const int signal : {SIGINT, SIGTERM}) {
        struct sigaction now {};
        sigaction(signal, nullptr, &now);
        if (now.sa_handler == note) std::signal(signal, SIG_DFL);
    }
}

int StopSignal::caught() {
    return noted;
}

const char* name_of_signal(int signal) {
    return signal == SIGINT ? "SIGINT" : "SIGTERM";
}

}  // namespace plumb::cli
