"""What of the lock counts on which platform; that pip finds it all there is asked by `make platforms`."""

import pytest

from book.tools import platforms


def names(platform: str, python: str) -> set[str]:
    lines = platforms.wanted(platform, python)
    assert all("--hash=sha256:" in line and "==" in line for line in lines)
    found = [line.partition("==")[0] for line in lines]
    assert len(found) == len(set(found)) > 100  # one version of each
    return set(found)


def test_each_platform_has_its_own_and_the_rest_is_common():
    on = {platform: names(platform, "3.13") for platform in platforms.PLATFORMS}
    assert on["Windows"] - on["Linux"] == {"colorama", "pywinpty"}
    assert on["macOS"] - on["Linux"] == {"appnope"}
    assert "numpy" in set.intersection(*on.values())


@pytest.mark.parametrize("answers", [(True, 0), (False, 1)])
def test_one_platform_that_fails_is_a_failure(monkeypatch, capsys, answers):
    good, status = answers
    monkeypatch.setattr(platforms, "resolves", lambda platform, python: good or platform != "Windows")
    assert platforms.main() == status
    assert f"platforms: {6 if good else 4} of 6 install the lock" in capsys.readouterr().out
