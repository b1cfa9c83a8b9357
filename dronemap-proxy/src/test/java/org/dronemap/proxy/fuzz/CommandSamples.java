package org.dronemap.proxy.fuzz;

import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** Commands of each kind. */
public final class CommandSamples {
    private static final Geodetic HERE = new Geodetic(47.4, 8.5);
    private static final MissionItem WAYPOINT = new MissionItem.Waypoint(HERE, Altitude.aboveHome(30), 0);
    private static final FenceArea FENCE =
            new FenceArea.Polygon(true, List.of(HERE, new Geodetic(47.5, 8.5), new Geodetic(47.4, 8.6)));

    private static final List<OverriddenParameter> KEPT =
            List.of(new OverriddenParameter("FS_GCS_ENABLE", 0, 1), new OverriddenParameter("FS_OPTIONS", 0, 16, 18));

    private static final Map<Class<?>, Object> PARTS =
            Map.of(int.class, 12, double.class, 12.0, boolean.class, true, String.class, "GUIDED");

    private CommandSamples() {}

    public static Stream<Command> of(CommandKind kind) {
        return switch (kind) {
            case DISARM -> Stream.of(new Command.Disarm(false), new Command.Disarm(true));
            case SET_MODE -> Stream.of(new Command.SetMode("GUIDED"));
            case GO_TO -> Stream.of(new Command.GoTo(HERE, Altitude.aboveHome(30)));
            case UPLOAD_MISSION -> upload();
            case SET_HOME ->
                Stream.of(
                        new Command.SetHome(null, null),
                        new Command.SetHome(HERE, new Altitude(500, Altitude.Reference.AMSL)));
            case SET_PARAMETERS -> Stream.of(new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 1_500))));
            case SET_CLOUD_LOSS -> Stream.of(new SetCloudLossAction(20, KEPT, new Agreeing()));
            case PUT_BACK -> Stream.of(new RestoreParameters(KEPT, new Agreeing()));
            case DOWNLOAD_LOG -> Stream.of(new Command.DownloadLog(new VehicleLog(1, null, 20_000), new Swallowing()));
            case SET_FENCE -> Stream.of(new SetFence(List.of(FENCE)));
            case SET_RALLY_POINTS -> Stream.of(new SetRallyPoints(List.of(new RallyPoint(HERE, 30))));
            default -> Stream.of(made(kind));
        };
    }

    /** Of numbers, choices and the like alone; a kind with other parts has to say above what there is in them. */
    private static Command made(CommandKind kind) {
        Class<?> record = records(Command.class)
                .filter(one -> one.getAnnotation(Stored.class).as().equals(kind.word()))
                .findFirst()
                .orElseThrow();
        RecordComponent[] parts = record.getRecordComponents();
        try {
            Constructor<?> constructor = record.getDeclaredConstructor(
                    Stream.of(parts).map(RecordComponent::getType).toArray(Class<?>[]::new));
            return (Command) constructor.newInstance(
                    Stream.of(parts).map(part -> value(kind, part)).toArray());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("Say what one of " + kind + " is", e);
        }
    }

    private static Stream<Class<?>> records(Class<?> family) {
        return Stream.of(family.getPermittedSubclasses())
                .flatMap(one -> one.isRecord() ? Stream.of(one) : records(one));
    }

    private static @Nullable Object value(CommandKind kind, RecordComponent part) {
        Class<?> type = part.getType();
        if (part.getAnnotatedType().isAnnotationPresent(Nullable.class)) {
            return null;
        }
        if (type.isEnum()) {
            return type.getEnumConstants()[type.getEnumConstants().length - 1];
        }
        Object value = PARTS.get(type);
        if (value == null) {
            throw new IllegalStateException(
                    "Say what one of " + kind + " is: nobody knows what its " + part + " may be");
        }
        return value;
    }

    private static Stream<Command> upload() {
        return Stream.of(
                new Command.UploadMission(new Mission(List.of(new MissionItem.TakeOff(20), WAYPOINT, WAYPOINT))));
    }

    /** Keeps nothing, and says that it does. */
    private static final class Agreeing implements ParameterOverrideRecorder {
        @Override
        public double returnMeters(double owners) {
            return owners + 5;
        }

        @Override
        public CompletableFuture<Void> keep(OverridePlan plan) {
            return CompletableFuture.completedFuture(null);
        }

        @Override
        public void skipped(List<ParameterValue> shown) {
            // Nobody asks.
        }
    }

    /** Takes every piece of a log and keeps none. */
    private static final class Swallowing implements VehicleLogSink {
        private State state = State.OPEN;

        @Override
        public BitSet kept() {
            state = State.OPEN;
            return new BitSet();
        }

        @Override
        public boolean put(int piece, byte[] bytes) {
            return true;
        }

        @Override
        public boolean complete(long sizeBytes) {
            state = State.WRITTEN;
            return true;
        }

        @Override
        public void interrupted() {
            // Nothing was kept that could be gone on with.
        }

        @Override
        public State state() {
            return state;
        }
    }
}
