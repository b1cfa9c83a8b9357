package org.dronemap.proxy.roslink.wire;

/** The two JSON layouts of ROSLink messages that robots use; each robot is answered in its own. */
public enum PacketLayout {
    /** The header in an object {@code header}, the body beside it: what public bridges send. */
    NESTED_HEADER,
    /** The header's fields at the top, the body in an object {@code payload}: what the protocol's papers show. */
    PAYLOAD
}
