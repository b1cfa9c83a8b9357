package org.dronemap.proxy.session;

/** From where unknown vehicles become drones by themselves; from anywhere else they wait until somebody lets them in. */
public enum Enrolment {
    /** From this machine only. */
    LOOPBACK,
    /** From everywhere: for networks where only one's own vehicles are. */
    EVERYWHERE,
    /** From nowhere. */
    NOWHERE;

    boolean admits(LinkLabel label) {
        return switch (this) {
            case LOOPBACK -> label.local();
            case EVERYWHERE -> true;
            case NOWHERE -> label.replay();
        };
    }
}
