package org.dronemap.proxy.session;

/** The setting that says from where unknown vehicles become drones without an administrator's approval. */
public enum Enrolment {
    /** From this machine only. */
    LOOPBACK,
    /** From everywhere: for networks where only one's own vehicles are. */
    EVERYWHERE,
    /** From nowhere. */
    NOWHERE;

    boolean admits(LinkOrigin label) {
        return this == NOWHERE ? label.replay() : admits(label.local());
    }

    /** {@code local}: only this machine can be on the other side. */
    public boolean admits(boolean local) {
        return this == EVERYWHERE || (this == LOOPBACK && local);
    }
}
