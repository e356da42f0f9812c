"""Output for notebooks: small tables, spheres, slices."""
from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .material import Material
    from .table import Table

SIDE = 192  # pixels of a sphere


def _row(tag: str, texts: Sequence[str]) -> str:
    cells = "".join(f'<{tag} style="text-align:left">{html.escape(t)}</{tag}>' for t in texts)
    return f"<tr>{cells}</tr>"


def table_html(title: str, head: Sequence[str], rows: Sequence[Sequence[str]], picture: bytes | None = None) -> str:
    """Returns a table with a title, and the PNG `picture` next to the table."""
    block = (f"<div><b>{html.escape(title)}</b><table><thead>{_row('th', head)}</thead><tbody>"
             f"{''.join(_row('td', row) for row in rows)}</tbody></table></div>")
    if picture is None:
        return block
    image = f'<img alt="{html.escape(title)}" src="data:image/png;base64,{base64.b64encode(picture).decode()}"/>'
    return f'<div style="display:flex;gap:1em;align-items:center">{image}{block}</div>'


def _axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("slices need matplotlib, which is not installed (Debian: python3-matplotlib)") from error
    return plt.subplots()[1]


def plot_slices(material: Material | None, table: Table | None, theta_i: Sequence[float], axes: Any) -> Any:
    """Plots f_r in the plane of incidence over the viewing angle, which is positive on the mirror side."""
    drawn = _axes(axes)
    angles = np.linspace(-89.0, 89.0, 357)
    for k, theta in enumerate(theta_i):
        colour = f"C{k % 10}"
        if material is not None:
            f = material.eval_degrees(theta, 180.0, np.abs(angles), np.where(angles < 0, 180.0, 0.0))
            drawn.plot(angles, f.mean(axis=-1), color=colour, label=f"{theta:g}°")
        if table is not None:
            where, values = table.in_plane(theta)
            label = None if material is not None else f"{theta:g}°"
            drawn.plot(where, values.mean(axis=-1), ".", color=colour, label=label)
    drawn.set_xlabel("viewing angle in the plane of incidence, degrees")
    drawn.set_ylabel("f_r, mean over channels, 1/sr")
    drawn.set_yscale("log")
    drawn.legend(title="incidence")
    return drawn
