# SPDX-License-Identifier: Apache-2.0
"""Cases built in Python are those of files, with the same checks."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kerf


def test_tables_and_text_are_the_same_case(case: kerf.Case, tmp_path: Path) -> None:
    file = tmp_path / "small.toml"
    file.write_text(case.text, encoding="utf-8")
    assert kerf.Case.read(file).used == case.used
    assert kerf.Case(case.text).used == case.used
    assert kerf.Case(case.used).used == case.used


def test_properties(case: kerf.Case) -> None:
    assert (case.title, case.dimension) == ("Jet on curd", 2)
    assert case.end == pytest.approx(3e-3)
    assert case.names == ["block", "jet"]


def test_derived_numbers_follow_from_the_case(case: kerf.Case) -> None:
    derived = case.derived
    assert derived["jet_speed"] == pytest.approx(10.0)
    assert derived["stagnation_pressure"] == pytest.approx(0.5 * 1000.0 * 10.0**2, rel=0.01)
    cost = case.cost()
    assert cost["initial_particles"] >= 40 * 10
    assert cost["steps"] == pytest.approx(case.end / cost["time_step"], rel=0.02)


def test_every_template_is_a_case() -> None:
    templates = kerf.templates()
    assert "tofu-5ms" in templates
    assert kerf.Case(templates["tofu-5ms"]).dimension == 2


def test_a_wrong_value_is_refused_with_the_remedy(tables: dict[str, Any]) -> None:
    tables["jet"][0]["speed"] = "10 kpa"
    with pytest.raises(kerf.CaseError, match="speed") as refused:
        kerf.Case(tables, "mine.toml")
    assert "mine.toml" in str(refused.value)
    assert isinstance(refused.value, kerf.KerfError)


def test_a_refusal_names_what_was_written_and_no_line_of_tables(tables: dict[str, Any]) -> None:
    with pytest.raises(kerf.CaseError, match=r"mine\.toml: jet\.jet\.sped = .*unknown"):
        kerf.replaced(kerf.Case(tables, "mine.toml"), {"jet.jet.sped": "5 m/s"})
    with pytest.raises(kerf.CaseError, match=r"mine\.toml:1: "):
        kerf.Case("title = 3", "mine.toml")


def test_a_value_that_toml_cannot_hold_is_refused(tables: dict[str, Any]) -> None:
    tables["dimension"] = object()
    with pytest.raises(TypeError, match="a case cannot hold"):
        kerf.Case(tables)


def test_numbers_of_numpy_are_numbers(tables: dict[str, Any]) -> None:
    tables["dimension"] = np.int64(2)
    tables["materials"]["curd"]["failure_strain"] = np.float64(0.05)
    plain = kerf.Case(tables).used
    tables["body"][0]["shape"]["minimum"] = np.array(["-20 mm", "0 mm"])
    tables["output"]["picture_times"] = ("0 ms", "1 ms")
    assert kerf.Case(tables).used != plain
    del tables["output"]["picture_times"]
    assert kerf.Case(tables).used == plain


def test_replaced_changes_what_it_names(case: kerf.Case) -> None:
    other = kerf.replaced(case, {"jet.0.speed": "20 m/s", "time.end": "1 ms"})
    assert other.derived["jet_speed"] == pytest.approx(20.0)
    assert other.end == pytest.approx(1e-3)
    assert case.end == pytest.approx(3e-3)
    without = kerf.replaced(case, {"materials.curd.fracture_energy": "2 J/m2", "probe": None})
    assert "probe" not in without.text
    with pytest.raises(KeyError, match="no index"):
        kerf.replaced(case, {"jet.3.speed": "20 m/s"})
    with pytest.raises(KeyError, match='names are "jet"'):
        kerf.replaced(case, {"jet.jett.speed": "20 m/s"})
    with pytest.raises(kerf.CaseError, match="sped"):
        kerf.replaced(case, {"jet.0.sped": "20 m/s"})


def test_replaced_takes_names_as_the_program_does(case: kerf.Case) -> None:
    by_name = kerf.replaced(case, {"jet.jet.speed": "20 m/s", "body.block.shape.maximum.1": "9 mm"})
    by_number = kerf.replaced(case, {"jet.0.speed": "20 m/s", "body.0.shape.maximum.1": "9 mm"})
    assert by_name.used == by_number.used
    assert by_name.used != case.used
    with pytest.raises(KeyError, match=r"the same key as jet\.0\.speed"):
        kerf.replaced(case, {"jet.0.speed": "20 m/s", "jet.jet.speed": "10 m/s"})


def test_replaced_bases_a_material_on_that_of_the_library(case: kerf.Case) -> None:
    of_library = kerf.replaced(case, {"body.block.material": "gelatin-10"})
    other = kerf.replaced(of_library, {"materials.gelatin-10.density": "1234 kg/m3"})
    assert "base = 'gelatin-10'" in other.text
    assert "1234" in other.used
