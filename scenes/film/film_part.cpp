#include "scenes/film/film_part.h"

#include <fmt/format.h>

#include <cstring>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "core/random.h"

namespace plumb {

namespace {

constexpr std::string_view magic = "PLUMBFILM4\n";

template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

class Writer {
public:
    std::string bytes{magic};

    template <Plain T>
    void operator()(const T& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void operator()(const std::string& text) {
        (*this)(text.size());
        bytes += text;
    }
    template <Plain T>
    void operator()(const std::vector<T>& values) {
        (*this)(values.size());
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void operator()(const WideSums& wide) {
        (*this)(wide.sums().size());
        for (const auto& [number, sum] : wide.sums()) {
            (*this)(number);
            (*this)(sum);
        }
    }
};

class Reader {
public:
    Reader(std::string_view bytes, const std::filesystem::path& file) : rest_(bytes), file_(file) {}

    template <Plain T>
    T plain() {
        T value;
        std::memcpy(&value, take(1, sizeof value), sizeof value);
        return value;
    }
    std::string text() {
        const auto size = plain<std::size_t>();
        return {take(size, 1), size};
    }
    template <Plain T>
    void fill(std::vector<T>& values) {
        if (const auto size = plain<std::size_t>(); size != values.size()) throw damaged();
        std::memcpy(values.data(), take(values.size(), sizeof(T)), values.size() * sizeof(T));
    }
    /// Reads wide sums, which stand for numbers below `sums`.
    void fill(WideSums& wide, std::size_t sums) {
        for (auto left = plain<std::size_t>(); left > 0; --left) {
            const auto number = plain<std::size_t>();
            if (number >= sums) throw damaged();
            wide.merge(number, plain<WideSum>());
        }
    }
    [[nodiscard]] Error damaged() const {
        return Error(file_.string() + ": cut off or damaged: its checksum is not that of its content");
    }

    void skip(std::size_t bytes) { take(bytes, 1); }

private:
    const char* take(std::size_t count, std::size_t size) {
        if (count > rest_.size() / size) throw damaged();
        const char* from = rest_.data();
        rest_.remove_prefix(count * size);
        return from;
    }

    std::string_view rest_;
    const std::filesystem::path& file_;
};

}  // namespace

// What a file holds of a film, in this order.
struct FilmBits {
    static void write(const Film& film, Writer& to) {
        to(film.size_);
        to(film.layers_.size());
        for (const auto& [name, channels, non_negative, exponent] : film.layers_) {
            to(name);
            to(channels.size());
            for (const std::string& channel : channels) to(channel);
            to(non_negative);
            to(exponent);
        }
        to(film.replicates_);
        to(film.bad_);
        to(film.sums_);
        to(film.squares_);
        to(film.wide_sums_);
        to(film.wide_squares_);
        to(film.samples_);
    }
    static Film read(Reader& from) {
        const auto size = from.plain<FilmSize>();
        std::vector<FilmLayer> layers;
        for (auto left = from.plain<std::size_t>(); left > 0; --left) {
            FilmLayer& layer = layers.emplace_back(FilmLayer{from.text(), {}});
            for (auto channels = from.plain<std::size_t>(); channels > 0; --channels)
                layer.channels.push_back(from.text());
            layer.non_negative = from.plain<bool>();
            layer.exponent = from.plain<int>();
        }
        Film film(size, std::move(layers));
        film.replicates_ = from.plain<std::uint64_t>();
        film.bad_ = from.plain<BadValues>();
        from.fill(film.sums_);
        from.fill(film.squares_);
        from.fill(film.wide_sums_, film.sums_.size());
        from.fill(film.wide_squares_, film.squares_.size());
        from.fill(film.samples_);
        return film;
    }
};

namespace {

void require_same_picture(const FilmPart& one, const std::filesystem::path& file_of_one, const FilmPart& other,
                          const std::filesystem::path& file) {
    auto with_parts = [](const FilmPart& part) {
        auto metadata = part.metadata;
        metadata["number of parts"] = std::to_string(part.parts);
        return metadata;
    };
    const auto a = with_parts(one), b = with_parts(other);
    const auto value = [](const auto& of, const std::string& name) {
        const auto found = of.find(name);
        return found == of.end() ? "not given" : "'" + found->second + "'";
    };
    for (const auto* names : {&a, &b})
        for (const auto& [name, text] : *names)
            if (value(a, name) != value(b, name))
                throw Error(fmt::format("{}: {} is {}, but {} in {}: parts of different pictures", file.string(), name,
                                        value(b, name), value(a, name), file_of_one.string()));
}

}  // namespace

void write_film_part(const std::filesystem::path& file, const FilmPart& part) {
    Writer to;
    to(part.metadata.size());
    for (const auto& [name, value] : part.metadata) {
        to(name);
        to(value);
    }
    to(part.part);
    to(part.parts);
    to(part.rays);
    FilmBits::write(part.film, to);
    to(stream_id(to.bytes));
    write_file(file, to.bytes);
}

FilmPart read_film_part(const std::filesystem::path& file) {
    const std::string bytes = read_file(file);
    if (!bytes.starts_with(magic))
        throw Error(file.string() + ": not a part of a film, as plumb render --shard writes");
    const std::string_view content = std::string_view(bytes).substr(0, bytes.size() - sizeof(std::uint64_t));
    Reader from(bytes, file), end(std::string_view(bytes).substr(content.size()), file);
    if (content.size() < magic.size() || end.plain<std::uint64_t>() != stream_id(content)) throw from.damaged();
    from.skip(magic.size());
    std::map<std::string, std::string> metadata;
    for (auto left = from.plain<std::size_t>(); left > 0; --left) {
        const std::string name = from.text();
        metadata[name] = from.text();
    }
    const auto part = from.plain<std::uint32_t>(), parts = from.plain<std::uint32_t>();
    const auto rays = from.plain<std::uint64_t>();
    return {std::move(metadata), part, parts, rays, FilmBits::read(from)};
}

FilmPart read_film_parts(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) throw Error("there is no part of a film");
    std::optional<FilmPart> whole;
    std::map<std::uint32_t, std::filesystem::path> there;
    for (const std::filesystem::path& file : files) {
        FilmPart next = read_film_part(file);
        const auto [twin, is_new] = there.try_emplace(next.part, file);
        if (whole) require_same_picture(*whole, files.front(), next, file);
        if (!is_new)
            throw Error(fmt::format("{}: part {} of {}, as is {}", file.string(), next.part, next.parts,
                                    twin->second.string()));
        if (!whole) {
            whole = std::move(next);
            continue;
        }
        whole->film.merge(next.film);
        whole->rays += next.rays;
    }
    for (std::uint32_t part = 1; part <= whole->parts; ++part)
        if (!there.contains(part))
            throw Error(fmt::format("part {} of {} is missing beside {}", part, whole->parts, files.front().string()));
    whole->part = whole->parts = 1;
    return std::move(*whole);
}

}  // namespace plumb
