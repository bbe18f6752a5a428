#include "core/random.h"

#include <numeric>
#include <random>

namespace plumb {

std::uint64_t stream_id(std::string_view name) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

std::uint64_t fresh_seed() {
    std::random_device entropy;
    return (static_cast<std::uint64_t>(entropy()) << 32 | entropy()) >> 11;
}

std::uint64_t RandomStream::below(std::uint64_t n) {
    __extension__ using Wide = unsigned __int128;
    const std::uint64_t reject_below = (0 - n) % n;  // 2^64 mod n: the low products that would favour some values
    for (;;) {
        const Wide product = static_cast<Wide>(bits()) * n;
        if (static_cast<std::uint64_t>(product) >= reject_below) return static_cast<std::uint64_t>(product >> 64);
    }
}

std::vector<std::uint32_t> random_permutation(std::uint32_t n, RandomStream& random) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    shuffle(std::span(order), random);
    return order;
}

}  // namespace plumb
