package org.dronemap.ws.stream;

import org.dronemap.ws.service.WireNames;

/** What there is of requests on the stream; {@link StreamRules} says by what each is judged. */
enum StreamRequestKind {
    AUTHENTICATE,
    COMMAND,
    CONTROL,
    STEER,
    LET_GO,
    POSITIONS,
    SUBSCRIBE,
    PING;

    /** As clients call it. */
    String word() {
        return WireNames.camel(this);
    }
}
