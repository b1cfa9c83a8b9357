package org.dronemap.proxy.roslink.wire;

/** The two ways in which robots lay out a message; each is answered in its own. */
public enum PacketLayout {
    /** The header in an object {@code header}, the body beside it: what public bridges send. */
    NESTED_HEADER,
    /** The header's fields at the top, the body in an object {@code payload}: what the protocol's papers show. */
    PAYLOAD
}
