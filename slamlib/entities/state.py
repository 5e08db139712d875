"""The state that the filter estimates: all robots, sensors and landmarks, as blocks of one joint Gaussian."""

from dataclasses import dataclass, field

from slamlib.belief import Belief
from slamlib.entities.landmark import Landmark, group_by_kind, landmark_means, state_rows
from slamlib.entities.linearization import Linearization
from slamlib.entities.rig import RigSensor, Robot
from slamlib.kalman.state import StateLayout, places
from slamlib.manifolds import Array, Euclidean, Indices


@dataclass(frozen=True, eq=False)
class KindRows:
    """All landmarks of one kind, their rows (n, dof) of the covariance, and where their means lie in the layout."""

    landmarks: list[Landmark]
    rows: Indices
    places: Indices | None

    def means(self, layout: StateLayout | None) -> Array:
        """Means (n, size) of the landmarks."""
        if layout is None or self.places is None:
            return landmark_means(self.landmarks)
        return layout.flat.take(self.places)


@dataclass(eq=False)
class State:
    """The robots, sensors and landmarks of one filter, and the belief whose blocks they are."""

    belief: Belief
    robots: list[Robot] = field(default_factory=list)
    sensors: list[RigSensor] = field(default_factory=list)
    landmarks: list[Landmark] = field(default_factory=list)
    _kinds: tuple[StateLayout | None, list[KindRows]] = field(default=(None, []), repr=False)

    @property
    def layout(self) -> StateLayout | None:
        """How the blocks lie among the rows of the covariance: another one whenever a block comes, goes or changes."""
        return self.landmarks[0].block.layout if self.landmarks else None

    def kinds(self) -> list[KindRows]:
        """The landmarks kind by kind, looked up once for each layout of the blocks."""
        layout = self.layout
        if layout is None or self._kinds[0] is not layout:
            self._kinds = layout, [KindRows(g, state_rows(g), _places(g)) for g in group_by_kind(self.landmarks)]
        return self._kinds[1]

    @property
    def linearization(self) -> Linearization | None:
        """The linearization points; None: the present means."""
        return self.sensors[0].linearization

    @linearization.setter
    def linearization(self, linearization: Linearization | None) -> None:
        for sensor in self.sensors:
            sensor.linearization = linearization
        if linearization is not None:
            linearization.added(self.belief.blocks, [block.mean for block in self.belief.blocks])

    def remove(self, landmark: Landmark) -> None:
        """Delete a landmark: what remains is the marginal of the others."""
        self.belief.remove(landmark.block)
        self.landmarks.remove(landmark)


def _places(group: list[Landmark]) -> Indices | None:
    """Where the means of landmarks of one kind lie in their layout; None if they are no vectors."""
    return places([landmark.block for landmark in group]) if type(group[0].block.manifold) is Euclidean else None
