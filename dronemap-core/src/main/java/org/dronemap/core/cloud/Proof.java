package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Evidence;

/** What nobody but the vehicle itself can show. */
public sealed interface Proof {
    Evidence evidence();

    /** The identity that an authenticated link was opened with. */
    record OfLink(String identity) implements Proof {
        @Override
        public Evidence evidence() {
            return Evidence.LINK;
        }
    }

    /** Frames signed with the key of this drone. */
    record OfSignature(DroneId drone) implements Proof {
        @Override
        public Evidence evidence() {
            return Evidence.SIGNATURE;
        }
    }
}
