"""Spoiling of values, nested data, arrays and texts by a random number generator."""

from collections.abc import Iterator
from copy import deepcopy
from random import Random
from types import SimpleNamespace
from typing import Any

import numpy as np

from tests.support.hostile import DIGITS, NUMBERS, PIECES, TEXTS, THINGS, at, paths, scaled

FACTORS = [-1, 0, 0.5, 2, 1e-3, 1e3, 1e9, 1e-9, 1e200]
COUNTS = [0, 1, 2, 3, 7, 40, 2**31, 2**32, 2**53, 2**63 - 1, 2**63, 2**64 - 1, -1]


def data(random: Random, sound: Any, *, times: int) -> Any:
    """Plain data with so many changes of any kind."""
    changed = deepcopy(sound)
    for _ in range(times):
        found = list(paths(changed))
        if not found:
            break
        path = random.choice(found)
        place, key = at(changed, path[:-1]), path[-1]
        way = random.randrange(7)
        if way <= 1:
            place[key] = deepcopy(random.choice(random.choice([NUMBERS, TEXTS, THINGS])))
        elif way <= 3:
            place[key] = scaled(place[key], random.choice(FACTORS))
        elif way == 4:
            del place[key]
        elif way == 5:  # something from elsewhere
            place[key] = deepcopy(at(changed, random.choice(found)))
        elif isinstance(place, list):
            place.insert(key, deepcopy(place[key]))
        else:
            place[f"{key}s"] = place.pop(key)
    return changed


def numbers(random: Random, sound: Any, *, times: int) -> Any:
    """Plain data with so many numbers changed, mostly by factors that a line survives."""
    changed = deepcopy(sound)
    found = [p for p in paths(changed) if isinstance(at(changed, p), (int, float))]
    for path in random.choices(found, k=times):
        place, key = at(changed, path[:-1]), path[-1]
        way = random.random()
        if way < 0.6:
            place[key] = place[key] * random.choice([0.3, 0.7, 0.9, 1.1, 1.5, 3.0, 10.0])
        elif way < 0.9:
            place[key] = place[key] * 10.0 ** random.uniform(-6, 6)
        else:
            place[key] = random.choice([0, -1, 1e-12, 1e-6, 1.0, 1e6, 1e12, 1e100, 5e-324])
    return changed


def text(random: Random, sound: bytes) -> bytes:
    """A file in which one to four things are changed."""
    changed = sound
    for _ in range(random.randint(1, 4)):
        start = random.randint(0, len(changed))
        end = min(len(changed), start + random.randint(1, 40))
        way = random.randrange(6)
        if way == 0:
            changed = changed[:start] + random.choice(PIECES) + changed[start:]
        elif way == 1:
            changed = changed[:start] + changed[end:]
        elif way == 2:
            changed = changed[:end] + changed[start:end] * random.randint(1, 3) + changed[end:]
        elif way == 3:
            changed = changed[:start] + bytes([random.randrange(256)]) + changed[start + 1 :]
        elif way == 4:
            digits = [n for n, byte in enumerate(changed) if byte in b"0123456789"]
            if digits:
                place = random.choice(digits)
                new = random.choice(DIGITS).encode()
                changed = changed[:place] + new + changed[place + 1 :]
        else:
            lines = changed.split(b"\n")
            one, other = random.randrange(len(lines)), random.randrange(len(lines))
            lines[one], lines[other] = lines[other], random.choice([b"", b"  "]) + lines[one]
            changed = b"\n".join(lines)
    return changed


def call(random: Random, sound: Any) -> Any:
    """Arguments of a call with one to three things spoilt: numbers, sizes, types."""
    changed = _copied(sound)
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        # Every argument alike, however much is in it.
        argument = random.choice(
            list(changed) if isinstance(changed, dict) else range(len(changed))
        )
        inside = changed[argument]
        parts = list(_leaves(inside)) if isinstance(inside, (dict, list)) else []
        some = random.choices(parts, k=5) if parts else []
        place, key = random.choice([(changed, argument), *some])
        place[key] = _other(random, place[key])
    return _restored(changed)


class _Tuple(list[Any]):
    """A tuple that can be written to."""


class _Named(dict[str, Any]):
    """Fields of a named tuple that can be written to."""


def _restored(value: Any) -> Any:
    if isinstance(value, _Named):
        return SimpleNamespace(**{key: _restored(one) for key, one in value.items()})
    if isinstance(value, dict):
        return {key: _restored(one) for key, one in value.items()}
    if isinstance(value, list):
        return (tuple if isinstance(value, _Tuple) else list)(_restored(one) for one in value)
    return value


def _copied(value: Any) -> Any:
    """A copy that can be written to everywhere."""
    if isinstance(value, dict):
        return {key: _copied(one) for key, one in value.items()}
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return _Named({key: _copied(one) for key, one in value._asdict().items()})
    if isinstance(value, (list, tuple)):
        kind = _Tuple if isinstance(value, tuple) else list
        return kind(_copied(one) for one in value)
    return value.copy() if isinstance(value, np.ndarray) else value


def _leaves(value: Any) -> Iterator[tuple[Any, Any]]:
    items = value.items() if isinstance(value, dict) else enumerate(value)
    for key, one in list(items):
        yield value, key
        if isinstance(one, (dict, list)):
            yield from list(_leaves(one))[:200]


def _other(random: Random, value: Any) -> Any:  # noqa: PLR0911 - one for each type
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return random.choice([value + 1, value - 1, -value, *COUNTS])
    if isinstance(value, float):
        strange = [float("nan"), float("inf"), -1.0, 0.0, 1e308, 5e-324, 1e-9 * value, 1e9 * value]
        return random.choice([*strange, -value, value * 1.5])
    if isinstance(value, np.ndarray):
        return _array(random, value)
    if isinstance(value, list):
        parts = random.choice([value[:-1], value[1:], value * 2, [], list(reversed(value))])
        return type(value)(parts)
    if isinstance(value, dict):
        kept = list(value)
        return type(value)({key: value[key] for key in kept if key != random.choice(kept)})
    return random.choice([None, "", 0, [], "trapezoidal"])


def _array(random: Random, value: Any) -> Any:
    if value.dtype.names:
        return _table(random, value)
    way = random.randrange(8)
    if way == 0:
        return value[:-1]
    if way == 1:
        return np.concatenate([value, value[:1]]) if value.size else np.zeros(3)
    if way == 2:
        return np.zeros(value.shape, random.choice([np.float32, np.int64]))
    if way == 3 and value.ndim > 1:
        return np.asfortranarray(value)
    if value.size:
        place = tuple(random.randrange(size) for size in value.shape)
        other = _other(random, float(value[place]))
        value[place] = np.array(other).astype(value.dtype) if value.dtype == float else 2**31
    return value


def _table(random: Random, value: Any) -> Any:
    """A structured array with a row, a name, a type or a number spoilt."""
    way, name = random.randrange(6), random.choice(value.dtype.names)
    if way == 0:
        return value[:-1]
    if way == 1:
        return np.concatenate([value, value[:1]]) if value.size else np.zeros(3, value.dtype)
    if way == 2:
        return value[[one for one in value.dtype.names if one != name]]
    if way == 3:
        kinds = {one: value.dtype[one].base for one in value.dtype.names}
        kinds[name] = random.choice([np.float32, np.int32, np.float64, np.int64])
        shapes = {one: value.dtype[one].shape for one in value.dtype.names}
        return value.astype([(one, kinds[one], shapes[one]) for one in kinds])
    if value.size:
        row = random.randrange(value.size)
        other = _other(random, float(np.ravel(value[name][row])[0]))
        with np.errstate(all="ignore"):  # as near to it as the column has
            value[name][row] = np.array(other).astype(value.dtype[name].base)
    return value
