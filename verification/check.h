#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "verification/run.h"
#include "verification/verdict.h"

// A claim is judged by a check: a pure function of a subject and of a run, Verdict(const Subject&, const Run&). A check
// that draws nothing takes no run, one without a subject takes no subject. What the right and the wrong subjects share
// (delta, scene, reference) is bound in the check; what differs between them is the subject, a struct where it is
// several things.

namespace plumb {

using Check = std::function<Verdict(const Run&)>;

/// A subject with a known defect, given to the claim's check in place of the right one; the check must refute it.
/// Its bias is at least 2 delta, that of a claim's smallest mutant between 2 delta and 4 delta.
template <class Subject>
struct Wrong {
    std::string id;      ///< unique within its claim; reported as claim-id/mutant-id
    std::string defect;  ///< one sentence
    Subject subject;
};

namespace detail {

template <class Signature>
struct Judges;
template <class Subject>
struct Judges<std::function<Verdict(Subject)>> {
    using type = std::remove_cvref_t<Subject>;
};
template <class Subject>
struct Judges<std::function<Verdict(Subject, const Run&)>> {
    using type = std::remove_cvref_t<Subject>;
};

}  // namespace detail

/// The type of what a check judges: Subject of Verdict(const Subject&, const Run&) or Verdict(const Subject&).
template <class CheckOfSubject>
using SubjectOf = typename detail::Judges<decltype(std::function{std::declval<CheckOfSubject>()})>::type;

/// A type that is judged and judges nothing: if a subject were a check itself, a mutant could be refuted by another
/// check than the claim's.
template <class Subject>
concept Judgeable =
    std::copy_constructible<Subject> && !std::same_as<Subject, Verdict> &&
    !std::is_invocable_r_v<Verdict, const Subject&, const Run&> && !std::is_invocable_r_v<Verdict, const Subject&>;

/// A wrong subject together with the check of its claim. Only a Trial makes one.
class Mutant {
public:
    std::string id, defect;  ///< those of the Wrong

    [[nodiscard]] Verdict judge(const Run& run) const { return check_(run); }

private:
    friend class Trial;
    Mutant(std::string name, std::string sentence, Check check)
        : id(std::move(name)), defect(std::move(sentence)), check_(std::move(check)) {}

    Check check_;
};

/// A check with the right subject and each wrong one; empty until it is given a check.
class Trial {
public:
    Trial() = default;

    /// A trial by a check without a subject: there is nothing that a mutant could replace.
    template <class CheckAlone>
    requires std::is_invocable_r_v<Verdict, const CheckAlone&, const Run&> Trial(CheckAlone check)
        : right_(std::move(check)) {}

    /// A trial by a check Verdict(const Subject&, const Run&) or Verdict(const Subject&) of the subjects that it
    /// judges, which are kept by value.
    template <class CheckOfSubject>
    Trial(CheckOfSubject check, SubjectOf<CheckOfSubject> right,
          std::vector<Wrong<SubjectOf<CheckOfSubject>>> wrong = {})
        : right_(bound(check, std::move(right))) {
        static_assert(Judgeable<SubjectOf<CheckOfSubject>>,
                      "A subject that is a check itself would let a mutant be refuted by another check than its "
                      "claim's: pass what the check is to judge.");
        for (auto& [id, defect, subject] : wrong)
            mutants_.push_back(Mutant(std::move(id), std::move(defect), bound(check, std::move(subject))));
    }

    /// The verdict on the right subject.
    [[nodiscard]] Verdict judge(const Run& run) const { return right_(run); }
    [[nodiscard]] const std::vector<Mutant>& mutants() const { return mutants_; }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(right_); }

private:
    template <class CheckOfSubject, class Subject>
    static Check bound(CheckOfSubject check, Subject subject) {
        return [check = std::move(check), subject = std::move(subject)](const Run& run) -> Verdict {
            if constexpr (std::is_invocable_v<const CheckOfSubject&, const Subject&, const Run&>)
                return check(subject, run);
            else
                return check(subject);
        };
    }

    Check right_;
    std::vector<Mutant> mutants_;
};

}  // namespace plumb
