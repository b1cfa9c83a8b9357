package org.dronemap.core.zone;

import java.time.Instant;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.organisation.OrganisationId;

/**
 * An area that drones must stay in or out of; enforced by the cloud, whatever fence the vehicle has.
 *
 * @param name what people call it
 * @param changedBy who changed it last
 * @param organisation whose it is: binds nobody else, unless it is the default organisation's and for everybody
 */
public record Zone(
        String id,
        String name,
        FenceArea shape,
        AltitudeBand band,
        ZoneBinding binding,
        ZoneValidity validity,
        BreachAction onBreach,
        String changedBy,
        Instant changedAt,
        OrganisationId organisation) {
    /** Of the default organisation. */
    public Zone(
            String id,
            String name,
            FenceArea shape,
            AltitudeBand band,
            ZoneBinding binding,
            ZoneValidity validity,
            BreachAction onBreach,
            String changedBy,
            Instant changedAt) {
        this(id, name, shape, band, binding, validity, onBreach, changedBy, changedAt, OrganisationId.HOME);
    }

    public Zone {
        ShapeValidator.of(shape).ifPresent(fault -> {
            throw new IllegalArgumentException(fault);
        });
    }

    /** Binds whoever flies here, of whatever organisation. */
    public boolean isGlobal() {
        return organisation.isHome() && binding instanceof ZoneBinding.Everybody;
    }

    /** "the no-fly zone “Airport”". */
    public String words() {
        return words(shape, name);
    }

    /** The same for one that is not kept by the cloud. */
    public static String words(FenceArea shape, String name) {
        return (shape.inside() ? "the zone “" : "the no-fly zone “") + name + "”";
    }
}
