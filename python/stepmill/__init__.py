"""Stepmill from Python: STEP file or drawing in, proven milling plan out.

    import stepmill
    part = stepmill.load("bracket.step")
    plan = stepmill.plan(part)
    print(plan.data["totals"]["time_s"], plan.programs.keys())

What plans, inspections, rankings and quotes hold is what the program writes: `data` is plan.json (schemas/plan.schema.json)
as a dictionary, and so on; there is no second model. Lengths are in mm, times in seconds. Wrong input raises `Error`, a
ValueError whose text names file, place and what was expected. Work runs without Python's lock, on all cores.
"""
import json as _json

from . import _stepmill
from ._stepmill import Error, InternalError, Machine, Part, Points, ToolLibrary, __version__

__all__ = ["Error", "InternalError", "Machine", "Part", "Plan", "Points", "ToolLibrary", "inspect", "load", "load_all",
           "load_machine", "load_tools", "plan", "quote", "rank"]


def load_all(file, *, unit="", depths=None, outline="", thickness=0.0):
    """Every distinct solid of a STEP file (AP203, AP214, AP242), or the one part of a drawing (.dxf, .svg).

    unit: "mm", "cm", "m" or "inch", whatever the file says; "": as it says.
    depths, outline, thickness: of a drawing, in its unit (docs/drawings.md).
    """
    return _stepmill._load(file, unit, dict(depths or {}), outline, thickness)


def load(file, *, solid=None, unit="", depths=None, outline="", thickness=0.0):
    """The part of a file. One with several solids needs `solid`, a number from 0."""
    parts = load_all(file, unit=unit, depths=depths, outline=outline, thickness=thickness)
    if solid is None and len(parts) > 1:
        raise Error(f"{file}: holds {len(parts)} different solids; expected solid=0 to {len(parts) - 1}")
    wanted = 0 if solid is None else solid
    if not 0 <= wanted < len(parts):
        raise Error(f"{file}: has solids 0 to {len(parts) - 1}, not {wanted}")
    return parts[wanted]


def load_tools(file=None):
    """A tool library (docs/tool-library.md); None: the one that is built in."""
    return _stepmill._load_tools(file)


def load_machine(file=None):
    """A machine file; None: the machining centre that is built in."""
    return _stepmill._load_machine(file)


class Plan:
    """A plan with its proof. Its programs are there only where every operation is proven."""

    def __init__(self, proven):
        self._proven = proven
        self._data = None

    @property
    def json_text(self):
        """plan.json, byte for byte."""
        return self._proven.json_text

    @property
    def data(self):
        """plan.json as a dictionary."""
        if self._data is None:
            self._data = _json.loads(self._proven.json_text)
        return self._data

    @property
    def complete(self):
        """Is all machined that was asked for?"""
        return self._proven.complete

    @property
    def may_run(self):
        """Is all proven, and do the volume books close?"""
        return self._proven.may_run

    @property
    def programs(self):
        """Texts of the programs by file name; empty where may_run is False."""
        return self._proven.programs

    @property
    def features(self):
        """Ids of the features, such as "S1.F2"."""
        return self._proven.features

    def target(self, feature, chord_mm=0.01):
        """The ground to clear, in setup coordinates: its loops as rows x, y; numpy.asarray() reads each.

        Outer loops run counter-clockwise, holes clockwise. Arcs become chords no higher than `chord_mm`.
        """
        return self._proven.target(feature, chord_mm)

    def obstruction(self, feature, chord_mm=0.01):
        """What the cutter must not touch meanwhile, in the same way."""
        return self._proven.obstruction(feature, chord_mm)


def _objective(objective):
    if objective not in ("time", "cost"):
        raise Error(f"objective: expected time or cost, found {objective!r}")
    return objective == "cost"


def plan(part, tools=None, machine=None, *, material="aluminium", setups=(), objective="time", unit=""):
    """Plans a part and proves its programs, as `stepmill plan` does without further options.

    setups: tool axes in order, such as ["+z", "-x"]; none: as few as reach all.
    unit: what load() was given, for the record.
    """
    return Plan(_stepmill._plan(part, tools or load_tools(), machine or load_machine(), material, list(setups),
                                _objective(objective), unit))


def inspect(part, *, setups=()):
    """What it takes to mill a part, without tools: inspect.json as a dictionary."""
    return _json.loads(_stepmill._inspect(part, list(setups)))


def rank(part, tools=None, machine=None, *, material="aluminium", setups=(), feature=""):
    """Cutters by what they reach and how fast they cut [Lim2000]: the JSON of `stepmill rank` as a dictionary."""
    return _json.loads(_stepmill._rank(part, tools or load_tools(), machine or load_machine(), material, list(setups),
                                       feature))


def quote(planned, quantities=(1,)):
    """Time and price of lots: quote.json as a dictionary."""
    return _json.loads(_stepmill._quote(planned._proven, list(quantities)))
