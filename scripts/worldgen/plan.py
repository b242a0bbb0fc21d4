"""A floor plan as an image: what an architect's pen can do, in metres."""
import numpy as np

RESOLUTION = 0.05  # [m] edge of a pixel

# Grey values; the simulator reads the first three as materials, map_server as occupied.
WALL, DARK, GLASS = 0, 32, 64
UNKNOWN, FREE = 205, 254

WALL_THICKNESS = 0.15
JAMB = 0.10  # a door frame stands out of the wall by half a wall on each side


def pixels(metres):
    return int(round(metres / RESOLUTION))


class Plan:
    """x to the right, y up, origin at the lower left corner; rectangles are (x0, y0, x1, y1)."""

    def __init__(self, width_m, height_m):
        self.width_m, self.height_m = width_m, height_m
        self.grey = np.full((pixels(height_m), pixels(width_m)), UNKNOWN, np.uint8)

    def fill(self, x0, y0, x1, y1, grey):
        """Paints a rectangle; thinner than a pixel is drawn as one pixel."""
        column, row = pixels(min(x0, x1)), pixels(min(y0, y1))
        last_column = max(pixels(max(x0, x1)), column + 1)
        last_row = max(pixels(max(y0, y1)), row + 1)
        self.grey[max(row, 0):last_row, max(column, 0):last_column] = grey

    def room(self, x0, y0, x1, y1, thickness=WALL_THICKNESS):
        """Floor inside of the rectangle, walls around it (outside of the rectangle)."""
        t = thickness
        for wall in ((x0 - t, y0 - t, x1 + t, y0), (x0 - t, y1, x1 + t, y1 + t),
                     (x0 - t, y0, x0, y1), (x1, y0, x1 + t, y1)):
            self.fill(*wall, WALL)
        self.fill(x0, y0, x1, y1, FREE)

    def door(self, x, y, width=0.95, vertical=False, leaf=0):
        """An opening centred at (x, y) in a wall that is vertical or not, with its frame.

        leaf: 0 none, else the open door leaf stands at right angles to the wall, at the left or
        lower jamb; its sign says to which side.
        """
        half, deep, t = width / 2, JAMB / 2, WALL_THICKNESS / 2 + 0.001
        for side in (-1, 1):
            self._across(x, y, side * half, side * (half + JAMB), -t - deep, t + deep, vertical,
                         WALL)
        self._across(x, y, -half, half, -t - 0.05, t + 0.05, vertical, FREE)
        if leaf:
            near, far = (t, t + width) if leaf > 0 else (-t - width, -t)
            self._across(x, y, -half - 0.05, -half, near, far, vertical, WALL)

    def pane(self, x, y, width, vertical=False, grey=GLASS):
        """A stretch of wall made of something else: a closed glass door, a window."""
        half, t = width / 2, WALL_THICKNESS / 2 + 0.001
        self._across(x, y, -half, half, -t, t, vertical, FREE)
        self._across(x, y, -half, half, -0.05, 0.05, vertical, grey)

    def _across(self, x, y, along0, along1, across0, across1, vertical, grey):
        if vertical:
            self.fill(x + across0, y + along0, x + across1, y + along1, grey)
        else:
            self.fill(x + along0, y + across0, x + along1, y + across1, grey)

    def box(self, x, y, width, depth, grey=WALL):
        """Furniture that stands on the floor with its lower left corner at (x, y)."""
        self.fill(x, y, x + width, y + depth, grey)

    def table(self, x, y, width, depth):
        """Four legs under a top that the laser looks below; lower left corner at (x, y)."""
        for leg_x in (x, x + width - RESOLUTION):
            for leg_y in (y, y + depth - RESOLUTION):
                self.fill(leg_x, leg_y, leg_x + RESOLUTION, leg_y + RESOLUTION, WALL)

    def chair(self, x, y):
        """Four legs, 40 cm apart, centred at (x, y)."""
        self.table(x - 0.2, y - 0.2, 0.4, 0.4)

    def office_chair(self, x, y):
        """A five-star base on castors: a cross around the column."""
        for dx, dy in ((0, 0), (0.2, 0), (-0.2, 0), (0, 0.2), (0, -0.2)):
            self.fill(x + dx, y + dy, x + dx, y + dy, DARK if dx == dy == 0 else WALL)

    def desk(self, x, y, width=1.6, depth=0.8, chair='above'):
        """A desk on legs with its drawer box and an office chair on one side."""
        self.table(x, y, width, depth)
        self.box(x + width - 0.45, y + 0.1, 0.4, depth - 0.2)
        middle = x + 0.4 * width
        offset = {'above': depth + 0.35, 'below': -0.35}.get(chair)
        if offset is not None:
            self.office_chair(middle, y + offset)

    def disc(self, x, y, radius, grey=WALL):
        """A round thing: pillar, plant pot, bin."""
        rows, columns = np.indices(self.grey.shape)
        inside = ((columns + 0.5) * RESOLUTION - x) ** 2 + ((rows + 0.5) * RESOLUTION - y) ** 2
        self.grey[inside <= radius ** 2 + 1e-9] = grey

    def save(self, stem):
        """Writes <stem>.pgm and <stem>.yaml as map_server reads them."""
        height, width = self.grey.shape
        header = f'P5\n{width} {height}\n255\n'.encode()
        stem.with_suffix('.pgm').write_bytes(header + self.grey[::-1].tobytes())
        stem.with_suffix('.yaml').write_text(
            f'image: {stem.name}.pgm\nresolution: {RESOLUTION}\norigin: [0.0, 0.0, 0.0]\n'
            'negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n', encoding='utf-8')
