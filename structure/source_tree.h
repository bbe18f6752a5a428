#pragma once

#include <string>
#include <vector>

namespace plumb::structure {

/// A file of the repository, by its path from the root, as text without line breaks in sentences: comment signs at the
/// starts of lines are dropped, and string literals that follow one another are joined.
struct SourceFile {
    std::string path;
    std::string text;
};

/// The files that people write: code, documents, studies and scenes' known answers, without what is built or fetched.
/// What structure/additions holds is read where it goes, in a copy of the tree.
const std::vector<SourceFile>& source_files();

/// The lines of one file of the repository as they are.
std::vector<std::string> lines_of(const std::string& path);

/// Whether the repository has this file or folder.
bool exists(const std::string& path);

}  // namespace plumb::structure
