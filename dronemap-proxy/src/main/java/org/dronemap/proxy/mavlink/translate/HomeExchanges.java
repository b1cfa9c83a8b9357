package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.HomeRead;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.jspecify.annotations.Nullable;

/** Makes the exchanges that set or read a vehicle's home position. */
final class HomeExchanges {
    private static final int DO_SET_HOME = 179;
    private static final int FRAME_GLOBAL = 0;
    private static final float HERE = 1f;
    private static final float THERE = 0f;
    private static final double SAME_METERS = 1;
    private static final double HERE_METERS = 100;
    private static final String NO_HOME =
            "The vehicle has not told its home yet, so an altitude above it means nothing;"
                    + " give the altitude above sea level.";

    private HomeExchanges() {}

    /** A home in wire units: degrees × 1e7, metres above mean sea level. */
    private record WireHome(int latitudeE7, int longitudeE7, double altitudeMeters) {
        boolean matches(HomePosition home) {
            Geodetic said = TelemetryDecoder.point(home.latitude(), home.longitude());
            Geodetic meant = new Geodetic(latitudeE7 / 1e7, longitudeE7 / 1e7);
            return said != null
                    && Geodesy.distanceMeters(meant, said) <= SAME_METERS
                    && Math.abs(home.altitude() / 1000.0 - altitudeMeters) <= SAME_METERS;
        }
    }

    static Exchange read(CommandContext cockpit) {
        return new HomeRead(cockpit.target(), any -> true, HomeExchanges::words);
    }

    /** Altitudes go down above sea level: what is above home would move with it. */
    static Exchange set(CommandContext cockpit, Command.SetHome command) {
        Geodetic point = command.point();
        Altitude altitude = command.altitude();
        if (point == null || altitude == null) {
            return setAndConfirm(cockpit, null);
        }
        Double before = cockpit.status().homeAltitudeAmslMeters();
        if (altitude.reference() == Altitude.Reference.AMSL) {
            return setAndConfirm(cockpit, place(point, altitude.meters()));
        }
        return before == null
                ? BasicExchanges.refuse(OutcomeCode.HOME_UNKNOWN, NO_HOME)
                : setAndConfirm(cockpit, place(point, before + altitude.meters()));
    }

    private static WireHome place(Geodetic point, double altitudeMeters) {
        return new WireHome(
                MissionCodec.e7(point.latitudeDegrees()), MissionCodec.e7(point.longitudeDegrees()), altitudeMeters);
    }

    /**
     * Ordered once more when the vehicle keeps saying another home: an acknowledgement names only the command, so that
     * the late one of an order before may have passed for the one of this order, which is lost.
     */
    private static Exchange setAndConfirm(CommandContext cockpit, @Nullable WireHome place) {
        HomeRead first = reading(cockpit, place);
        BooleanSupplier elsewhere = () -> first.outcome() instanceof Outcome.Failed;
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> order(cockpit, place)),
                new ExchangeSequence.Step(() -> first, HomeExchanges::isReported),
                ExchangeSequence.Step.when(elsewhere, () -> order(cockpit, place)),
                ExchangeSequence.Step.when(elsewhere, () -> reading(cockpit, place))));
    }

    private static boolean isReported(Outcome outcome) {
        return switch (outcome.kind()) {
            case SUCCEEDED, FAILED -> true;
            case REFUSED, TIMED_OUT, SUPERSEDED, UNKNOWN -> false;
        };
    }

    private static HomeRead reading(CommandContext cockpit, @Nullable WireHome place) {
        return new HomeRead(
                cockpit.target(),
                home -> place == null ? isHere(cockpit.status(), home) : place.matches(home),
                HomeExchanges::words);
    }

    /** As far as the vehicle has told where it is; it may have flown on meanwhile. */
    private static boolean isHere(VehicleStatus status, HomePosition home) {
        Geodetic here = status.point();
        Geodetic said = TelemetryDecoder.point(home.latitude(), home.longitude());
        return here == null || (said != null && Geodesy.distanceMeters(here, said) <= HERE_METERS);
    }

    private static Exchange order(CommandContext cockpit, @Nullable WireHome place) {
        WireHome there = place == null ? new WireHome(0, 0, 0) : place;
        CommandInt message = new CommandInt(
                cockpit.target().systemId(),
                cockpit.target().componentId(),
                FRAME_GLOBAL,
                DO_SET_HOME,
                0,
                0,
                place == null ? HERE : THERE,
                0f,
                0f,
                place == null ? 0f : Float.NaN,
                there.latitudeE7(),
                there.longitudeE7(),
                (float) there.altitudeMeters());
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofInt(message, MavCommandRequest.Retry.REPEATABLE),
                cockpit.observer());
    }

    private static String words(HomePosition home) {
        return String.format(
                Locale.ROOT,
                "The vehicle says that its home is %.6f, %.6f at %.1f m.",
                home.latitude() / 1e7,
                home.longitude() / 1e7,
                home.altitude() / 1000.0);
    }
}
