#include "scenes/film/film_part.h"

#include <gmock/gmock.h>

#include "core/file.h"
#include "core/test_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

Film film_of(std::initializer_list<double> passes) {
    const std::vector<FilmLayer> layers{{"radiance", {"R", "G", "B"}}, {"depth", {"Z"}, false}};
    Film film({2, 1}, layers);
    for (const double value : passes) {
        FilmPass pass({2, 1}, layers);
        pass.add(0, 0, std::vector{Spectrum::rgb(value, 0.1, 1e-17), Spectrum::grey(-3e12)});
        pass.add(1, 0, std::vector{Spectrum::grey(NAN), Spectrum::grey(1e8)});
        film.add(pass);
    }
    return film;
}

class FilmPartFile : public testing::Test {
protected:
    [[nodiscard]] std::filesystem::path written(const std::string& name, const FilmPart& part) const {
        write_film_part(folder / name, part);
        return folder / name;
    }
    [[nodiscard]] std::string complaint(const std::vector<std::string>& names) const {
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names) files.push_back(folder / name);
        return error_of([&] { read_film_parts(files); });
    }
    TestFolder folder;
    std::map<std::string, std::string> of{{"seed", "7"}, {"scene", "box"}};
};

TEST_F(FilmPartFile, KeepsEveryBit) {
    const FilmPart part{of, 2, 3, 99, film_of({0.1, 0.2})};
    const FilmPart read = read_film_part(written("a", part));
    EXPECT_EQ(read.metadata, of);
    EXPECT_EQ(read.part, 2u);
    EXPECT_EQ(read.parts, 3u);
    EXPECT_EQ(read.rays, 99u);
    EXPECT_EQ(read.film.replicates(), 2u);
    EXPECT_EQ(read.film.bad_values(), part.film.bad_values());
    EXPECT_EQ(read.film.image().values, part.film.image().values);
    EXPECT_EQ(read.film.image().channels, part.film.image().channels);
    write_film_part(folder / "b", read);
    EXPECT_EQ(read_file(folder / "a"), read_file(folder / "b"));
}

TEST_F(FilmPartFile, PartsMakeTheWhole) {
    const auto first = written("a", {of, 1, 2, 10, film_of({0.1, 0.7})}),
               second = written("b", {of, 2, 2, 5, film_of({0.3})});
    const FilmPart merged = read_film_parts({second, first});
    EXPECT_EQ(merged.rays, 15u);
    EXPECT_EQ(merged.film.image().values, film_of({0.1, 0.3, 0.7}).image().values);
}

TEST_F(FilmPartFile, NamesWhatIsWrong) {
    const std::string bytes = read_file(written("a", {of, 1, 2, 0, film_of({1})}));
    static_cast<void>(written("other-count", {of, 2, 3, 0, film_of({1})}));
    static_cast<void>(written("again", {of, 1, 2, 0, film_of({1})}));
    static_cast<void>(written("other-seed", {{{"seed", "8"}, {"scene", "box"}}, 2, 2, 0, film_of({1})}));
    write_file(folder / "other", "SQLite format 3");
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    write_file(folder / "flipped", flipped);
    EXPECT_THAT(complaint({"none"}), HasSubstr("none"));
    EXPECT_THAT(complaint({"other"}), HasSubstr("other: not a part of a film"));
    EXPECT_THAT(complaint({"flipped"}), HasSubstr("flipped: cut off or damaged"));
    for (std::size_t size = 11; size < bytes.size(); ++size) {
        write_file(folder / "cut", bytes.substr(0, size));
        ASSERT_THAT(complaint({"cut"}), HasSubstr("cut: cut off or damaged")) << size;
    }
    EXPECT_THAT(complaint({"a"}), HasSubstr("part 2 of 2 is missing"));
    EXPECT_THAT(complaint({"a", "again"}), HasSubstr("again: part 1 of 2, as is "));
    EXPECT_THAT(complaint({"a", "other-seed"}), HasSubstr("other-seed: seed is '8', but '7' in "));
    EXPECT_THAT(complaint({"a", "other-count"}), HasSubstr("number of parts is '3', but '2'"));
}

}  // namespace
}  // namespace plumb
