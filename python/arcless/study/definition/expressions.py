"""Short expressions of numbers by name: ``std_force_N / mean_force_N``.

Parsed by Python's own parser, and evaluated by a walk over the few kinds of node that are let
through; nothing of the text is ever executed.
"""

import ast
import math
import operator
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from typing import Any

from arcless.errors import ModelError
from arcless.units import show

MAX_LENGTH = 400
FUNCTIONS: dict[str, Callable[..., float]] = {
    "min": min, "max": max, "abs": abs, "sqrt": math.sqrt,
}  # fmt: skip
_SINGLE = {"abs", "sqrt"}
_OPERATORS: dict[type[ast.AST], Callable[..., Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: math.pow, ast.UAdd: operator.pos, ast.USub: operator.neg,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
    ast.Eq: operator.eq, ast.NotEq: operator.ne,
}  # fmt: skip
ACCEPTED = "keys and numbers with + − * / ** ( ), comparisons, min, max, abs, sqrt"


class UndefinedError(ValueError):
    """An expression has no value here: division by zero, root of a negative number, overflow."""


class Expression:
    """A checked expression.

    Parameters
    ----------
    text
        As written.
    known
        The names that it may use.

    Raises
    ------
    ModelError
        Not an expression of the kind, or a name that is not known.
    """

    def __init__(self, text: str, known: list[str]) -> None:
        self.text = text
        self.names: set[str] = set()
        try:
            if len(text) > MAX_LENGTH:
                raise self._refused(f"{len(text)} characters")
            self._tree = ast.parse(text.strip(), mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            raise self._refused(show(text)) from None
        self._check(self._tree, known)

    def value(self, of: Mapping[str, float | None]) -> float | None:
        """Return the value; None where a number that it needs was not recorded.

        A comparison is 1 where it holds, 0 where not.

        Raises
        ------
        UndefinedError
            There is no value.
        """
        if any(of.get(name) is None for name in self.names):
            return None
        try:
            found = float(self._evaluate(self._tree, of))
        except ZeroDivisionError:
            raise UndefinedError("division by zero") from None
        except ValueError:
            raise UndefinedError("a root or power of a negative number") from None
        except OverflowError:
            found = math.inf
        if not math.isfinite(found):
            raise UndefinedError("out of the range of numbers")
        return found

    def _check(self, node: ast.AST, known: list[str]) -> None:
        name = _dotted(node)
        if name is not None:
            if name not in known:
                expected = "a key of the assessment, or a variable that is a number"
                hint = _near(name, known)
                raise ModelError("unknown key", got=show(name), expected=expected, hint=hint)
            self.names.add(name)
            return
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                children: list[ast.AST] = []
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                children = [left, right]
            case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
                children = [operand]
            case ast.Compare(left=left, ops=ops, comparators=others) if all(
                type(op) in _OPERATORS for op in ops
            ):
                children = [left, *others]
            case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]) if (
                function in FUNCTIONS
                and arguments
                and (len(arguments) == 1) == (function in _SINGLE)
            ):
                children = list(arguments)
            case _:
                raise self._refused(show(ast.unparse(node)))
        for child in children:
            self._check(child, known)

    def _evaluate(self, node: ast.AST, of: Mapping[str, float | None]) -> Any:
        name = _dotted(node)
        if name is not None:
            return of[name]
        match node:
            case ast.Constant(value=value):
                return float(value)  # type: ignore[arg-type]
            case ast.BinOp(left=left, op=op, right=right):
                return _OPERATORS[type(op)](self._evaluate(left, of), self._evaluate(right, of))
            case ast.UnaryOp(op=op, operand=operand):
                return _OPERATORS[type(op)](self._evaluate(operand, of))
            case ast.Compare(left=left, ops=ops, comparators=others):
                values = [self._evaluate(one, of) for one in (left, *others)]
                pairs = zip(ops, values, values[1:], strict=False)
                return float(all(_OPERATORS[type(op)](a, b) for op, a, b in pairs))
            case ast.Call(func=ast.Name(id=function), args=arguments):
                return FUNCTIONS[function](*(self._evaluate(one, of) for one in arguments))
        raise AssertionError(node)  # the check lets nothing else through

    @staticmethod
    def _refused(got: str) -> ModelError:
        return ModelError("not an expression", got=got, expected=ACCEPTED)


def _dotted(node: ast.AST) -> str | None:
    """Return the name that a node is, such as ``P2.mean_force_N`` or one with more dots."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        before = _dotted(node.value)
        return None if before is None else f"{before}.{node.attr}"
    return None


def _near(name: str, known: list[str]) -> str:
    close = get_close_matches(name, known, n=1)
    return f"did you mean {close[0]}?" if close else "the reference of study files lists the keys"
