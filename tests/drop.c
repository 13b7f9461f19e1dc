#include "drop.h"

#include "base/clock.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The library is opened when a test needs it, so that the other tests are not linked with it. */
typedef struct X11 {
    Display *(*open)(const char *);
    int (*close)(Display *);
    Atom (*intern)(Display *, const char *, Bool);
    Window (*create)(Display *, Window, int, int, unsigned, unsigned, unsigned, unsigned long, unsigned long);
    int (*own)(Display *, Atom, Window, Time);
    Status (*send)(Display *, Window, Bool, long, XEvent *);
    int (*pending)(Display *);
    int (*next)(Display *, XEvent *);
    int (*change)(Display *, Window, Atom, Atom, int, int, const unsigned char *, int);
    int (*flush)(Display *);
} X11;

static bool load(X11 *x11) {
    static const char *const names[] = {
        "XOpenDisplay", "XCloseDisplay", "XInternAtom", "XCreateSimpleWindow", "XSetSelectionOwner",
        "XSendEvent",   "XPending",      "XNextEvent",  "XChangeProperty",     "XFlush"};
    void *library = dlopen("libX11.so.6", RTLD_NOW);
    void *functions[sizeof names / sizeof *names];
    for (size_t i = 0; library && i < sizeof names / sizeof *names; i++) {
        functions[i] = dlsym(library, names[i]);
        if (!functions[i]) return false;
    }
    if (library) memcpy(x11, functions, sizeof *x11);
    return library != NULL;
}

typedef struct Hand {
    X11 x11;
    Display *display;
    Window source, target;
} Hand;

static Atom atom(const Hand *hand, const char *name) {
    return hand->x11.intern(hand->display, name, False);
}

static void say(const Hand *hand, const char *what, long a, long b, long c, long d) {
    XEvent event = {.xclient = {.type = ClientMessage,
                                .window = hand->target,
                                .message_type = atom(hand, what),
                                .format = 32,
                                .data.l = {(long)hand->source, a, b, c, d}}};
    hand->x11.send(hand->display, hand->target, False, NoEventMask, &event);
    hand->x11.flush(hand->display);
}

static void give(const Hand *hand, const XSelectionRequestEvent *request, const char *path) {
    char uri[1024];
    snprintf(uri, sizeof uri, "file://%s\r\n", path);
    hand->x11.change(hand->display, request->requestor, request->property, request->target, 8,
                     PropModeReplace, (const unsigned char *)uri, (int)strlen(uri));
    XEvent answer = {.xselection = {.type = SelectionNotify,
                                    .requestor = request->requestor,
                                    .selection = request->selection,
                                    .target = request->target,
                                    .property = request->property,
                                    .time = request->time}};
    hand->x11.send(hand->display, request->requestor, False, NoEventMask, &answer);
    hand->x11.flush(hand->display);
}

/* Answers what the window asks until it says this. */
static bool await(const Hand *hand, const char *what, const char *path) {
    for (double end = clock_seconds() + 20; clock_seconds() < end; usleep(5000)) {
        while (hand->x11.pending(hand->display)) {
            XEvent event;
            hand->x11.next(hand->display, &event);
            if (event.type == SelectionRequest) give(hand, &event.xselectionrequest, path);
            if (event.type == ClientMessage && event.xclient.message_type == atom(hand, what)) return true;
        }
    }
    return false;
}

bool drop_file(int display, unsigned long target, int x, int y, const char *path) {
    Hand hand = {.target = target};
    char name[32];
    snprintf(name, sizeof name, ":%d", display);
    if (!load(&hand.x11) || !(hand.display = hand.x11.open(name))) return false;
    hand.source = hand.x11.create(hand.display, DefaultRootWindow(hand.display), 0, 0, 1, 1, 0, 0, 0);
    hand.x11.own(hand.display, atom(&hand, "XdndSelection"), hand.source, CurrentTime);
    say(&hand, "XdndEnter", 5L << 24, (long)atom(&hand, "text/uri-list"), 0, 0);
    say(&hand, "XdndPosition", 0, (long)x << 16 | y, CurrentTime, (long)atom(&hand, "XdndActionCopy"));
    bool taken = await(&hand, "XdndStatus", path);
    say(&hand, "XdndDrop", 0, CurrentTime, 0, 0);
    taken = taken && await(&hand, "XdndFinished", path);
    hand.x11.close(hand.display);
    return taken;
}
