#include <fmt/format.h>

#include "session/argument_parser.h"
#include "text/error.h"

namespace lamella::session {

namespace {

double checked(const Argument& argument, double value, const text::Place& place) {
  const bool low =
      argument.least && (value < *argument.least || (argument.least_excluded && value == *argument.least));
  if (low || !(value == value)) {
    const std::string bound = argument.least_excluded
                                  ? fmt::format("greater than {:g}", *argument.least)
                                  : fmt::format("at least {:g}", argument.least.value_or(0));
    throw text::Error(place, fmt::format("{} must be {}, not {:.15g}", argument.name, bound, value));
  }
  if (argument.most && value > *argument.most) {
    throw text::Error(
        place, fmt::format("{} must be at most {:g}, not {:.15g}", argument.name, *argument.most, value));
  }
  return value;
}

std::optional<GivenValue> value_of(const TypedArgument& typed, language::Evaluation& evaluation) {
  const Argument& argument = *typed.argument;
  const auto first = [&]() -> const language::Expression& { return *typed.expressions.front(); };
  const bool none = !argument.word_for_none.empty() && typed.word == argument.word_for_none;
  if (none && argument.kind != ArgumentKind::word) return std::nullopt;
  switch (argument.kind) {
    case ArgumentKind::flag:
      return true;
    case ArgumentKind::number:
      return checked(argument, evaluate_number(first(), evaluation), typed.place);
    case ArgumentKind::count: {
      const long count = evaluate_count(first(), evaluation, argument.name);
      checked(argument, static_cast<double>(count), typed.place);
      return count;
    }
    case ArgumentKind::text:
      if (!argument.choices.empty()) return typed.word;
      return evaluate_text(first(), evaluation);
    case ArgumentKind::file:
      if (typed.expressions.empty()) return File{typed.word, typed.place};
      return File{evaluate_text(first(), evaluation), typed.place};
    case ArgumentKind::word:
      return Word{typed.word, typed.place};
    case ArgumentKind::numbers: {
      std::vector<double> numbers;
      for (const auto& expression : typed.expressions)
        numbers.push_back(evaluate_number(*expression, evaluation));
      return numbers;
    }
    case ArgumentKind::elements:
      return Elements{typed.generator->kind, evaluate_elements(*typed.generator, evaluation)};
    case ArgumentKind::selection:
      return Selection{&*typed.generator, typed.word};
    case ArgumentKind::expressions: {
      Expressions result;
      for (const auto& expression : typed.expressions) result.list.push_back(expression.get());
      return result;
    }
    case ArgumentKind::setting:
      return Setting{&*typed.generator, &*typed.attribute,
                     typed.expressions.empty() ? nullptr : typed.expressions.front().get(), typed.place};
    case ArgumentKind::definition: {
      Definition result{typed.word, typed.type, typed.attribute_of, {}, typed.place};
      for (const auto& expression : typed.expressions) result.sizes.push_back(expression.get());
      return result;
    }
    case ArgumentKind::printable:
      if (typed.expressions.empty()) return Printable(ProcedureName{typed.word});
      return Printable(typed.expressions.front().get());
    case ArgumentKind::field: {
      Field result = typed.field;
      result.value = typed.expressions.front().get();
      return result;
    }
    case ArgumentKind::commands:
      return Commands{typed.commands};
    case ArgumentKind::formulas:
      return *typed.formulas;
    case ArgumentKind::sample:
      return Sample{&*typed.generator, typed.expressions.front().get()};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Given> Invocation::evaluate(language::Evaluation& evaluation) const {
  std::vector<Given> result;
  for (const TypedArgument& typed : arguments) {
    if (std::optional<GivenValue> value = value_of(typed, evaluation))
      result.push_back({typed.argument, std::move(*value)});
  }
  return result;
}

}  // namespace lamella::session
