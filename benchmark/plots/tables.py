"""The tables that the experiments have written, as Python sees them."""
import csv


def asNumber(text):
    try:
        return float(text)
    except ValueError:
        return text


def readTable(path):
    """Rows as dictionaries; numbers as numbers."""
    with open(path, newline='', encoding='utf-8') as stream:
        return [{key: asNumber(text) for key, text in row.items()}
                for row in csv.DictReader(stream)]


def column(rows, key):
    return [row[key] for row in rows]


class Results:
    """A folder of tables: `<what>[_<word>...].csv`."""

    def __init__(self, folder):
        self.folder = folder

    def table(self, *words):
        return readTable(self.folder / ('_'.join(words) + '.csv'))

    def has(self, *words):
        return (self.folder / ('_'.join(words) + '.csv')).is_file()
