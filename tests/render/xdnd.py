"""Drops files on an X11 window as a file manager does, with the XDND protocol (version 5) through libX11.

    drop(display_name, window_id, paths, x, y)     returns when the target reports that it has finished
"""
import ctypes
import time
from ctypes import POINTER, Structure, Union, byref, c_char_p, c_int, c_long, c_uint, c_ulong, c_void_p
from urllib.parse import quote

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
ATOM_TYPE, CURRENT_TIME, PROP_MODE_REPLACE = 4, 0, 0


class ClientMessage(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("window", c_ulong), ("message_type", c_ulong), ("format", c_int), ("l", c_long * 5)]


class SelectionRequest(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("owner", c_ulong), ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong),
                ("property", c_ulong), ("time", c_ulong)]


class SelectionNotify(Structure):
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
                ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong), ("property", c_ulong),
                ("time", c_ulong)]


class Event(Union):
    _fields_ = [("type", c_int), ("client", ClientMessage), ("request", SelectionRequest), ("notify", SelectionNotify),
                ("pad", c_long * 24)]


def load():
    x = ctypes.CDLL("libX11.so.6")
    x.XOpenDisplay.restype = c_void_p
    x.XOpenDisplay.argtypes = [c_char_p]
    x.XDefaultRootWindow.restype = c_ulong
    x.XDefaultRootWindow.argtypes = [c_void_p]
    x.XInternAtom.restype = c_ulong
    x.XInternAtom.argtypes = [c_void_p, c_char_p, c_int]
    x.XCreateSimpleWindow.restype = c_ulong
    x.XCreateSimpleWindow.argtypes = [c_void_p, c_ulong, c_int, c_int, c_uint, c_uint, c_uint, c_ulong, c_ulong]
    x.XSetSelectionOwner.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong]
    x.XChangeProperty.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong, c_int, c_int, c_char_p, c_int]
    x.XSendEvent.argtypes = [c_void_p, c_ulong, c_int, c_long, POINTER(Event)]
    x.XPending.argtypes = x.XFlush.argtypes = x.XCloseDisplay.argtypes = [c_void_p]
    x.XNextEvent.argtypes = [c_void_p, POINTER(Event)]
    return x


def drop(display_name, target, paths, at_x=10, at_y=10, seconds=60):
    x = load()
    display = x.XOpenDisplay(display_name.encode())
    assert display, "no display"

    def atom(name):
        return x.XInternAtom(display, name.encode(), 0)

    own = x.XCreateSimpleWindow(display, x.XDefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)
    data = "".join(f"file://{quote(path)}\r\n" for path in paths).encode()
    uris, selection = atom("text/uri-list"), atom("XdndSelection")
    x.XSetSelectionOwner(display, selection, own, CURRENT_TIME)

    def send(message, *values):
        event = Event()
        event.client.type = CLIENT_MESSAGE
        event.client.window = target
        event.client.message_type = atom(message)
        event.client.format = 32
        for k, value in enumerate(values):
            event.client.l[k] = value
        x.XSendEvent(display, target, 0, 0, byref(event))
        x.XFlush(display)

    def answer(request):
        x.XChangeProperty(display, request.requestor, request.property, request.target, 8, PROP_MODE_REPLACE, data,
                          len(data))
        event = Event()
        event.notify.type = SELECTION_NOTIFY
        event.notify.requestor = request.requestor
        event.notify.selection = request.selection
        event.notify.target = request.target
        event.notify.property = request.property
        event.notify.time = request.time
        x.XSendEvent(display, request.requestor, 0, 0, byref(event))
        x.XFlush(display)

    status, finished = atom("XdndStatus"), atom("XdndFinished")
    send("XdndEnter", own, 5 << 24, uris)
    send("XdndPosition", own, 0, at_x << 16 | at_y, CURRENT_TIME, atom("XdndActionCopy"))
    dropped = False
    end = time.time() + seconds
    event = Event()
    try:
        while time.time() < end:
            if not x.XPending(display):
                time.sleep(0.01)
                continue
            x.XNextEvent(display, byref(event))
            if event.type == SELECTION_REQUEST:
                answer(event.request)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == status and not dropped:
                assert event.client.l[1] & 1, "the window does not take the drop"
                send("XdndDrop", own, 0, CURRENT_TIME)
                dropped = True
            elif event.type == CLIENT_MESSAGE and event.client.message_type == finished:
                return
        raise AssertionError("the window did not finish the drop")
    finally:
        x.XCloseDisplay(display)
