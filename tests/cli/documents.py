"""documents.py: variants of a JSON document for tests of a schema."""
import copy


def changer_of(full):
    """Returns the function changed(path, value, document=full): the document with this value at a path; `del` removes the value."""

    def changed(path, value, document=full):
        out = copy.deepcopy(document)
        place = out
        for key in path[:-1]:
            place = place[key]
        if value == "del":
            del place[path[-1]]
        else:
            place[path[-1]] = value
        return out

    return changed
