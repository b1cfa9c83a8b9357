package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionItemInt;

/**
 * Chooses the form in which a vehicle gets the items of one upload. Integers are exact and come first; who asks in the
 * old form, as some do that know both, and does not take them gets floating-point items.
 */
final class MissionItemForm {
    /** So often an item goes out as integers before anything else is thought of. */
    private static final int TRIES_BEFORE_FLOATS = 3;

    private boolean knowsIntegers;
    private boolean askedInOldForm;
    /** The item that is asked for went out in floating point, maybe beside integers. */
    private boolean sentAsFloats;

    private boolean integersTaken;
    private boolean floatsTaken;

    /** The vehicle says of itself that it takes integers, however it asks. */
    void knowsIntegers() {
        knowsIntegers = true;
    }

    void asked(boolean inOldForm) {
        askedInOldForm = inOldForm && !knowsIntegers;
    }

    /**
     * The item as it goes out now. Both forms by turns: of a vehicle that is hard to hear nobody knows which one arrived.
     *
     * @param tries how often it went out before
     */
    Message of(MissionItemInt item, int tries) {
        boolean turn = floatsTaken ? tries % 2 == 0 : tries >= TRIES_BEFORE_FLOATS && tries % 2 != 0;
        boolean floats = askedInOldForm && !integersTaken && turn;
        sentAsFloats = floats || (sentAsFloats && tries > 0);
        return floats ? LegacyMissionItems.older(item) : item;
    }

    /** The vehicle goes on behind the item that was asked for: it knows a form that this went out in. */
    void accepted() {
        floatsTaken |= sentAsFloats;
        integersTaken |= !sentAsFloats;
    }

    /** Nobody knows yet what it takes. */
    boolean isOpen() {
        return askedInOldForm && !integersTaken && !floatsTaken;
    }

    /** There is a form left to try. */
    boolean isUntried() {
        return isOpen() && !sentAsFloats;
    }

    boolean isRounded() {
        return floatsTaken;
    }
}
