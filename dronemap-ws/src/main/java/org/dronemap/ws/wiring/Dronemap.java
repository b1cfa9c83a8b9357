package org.dronemap.ws.wiring;

import java.util.List;
import java.util.Map;
import org.dronemap.core.time.SystemTime;
import org.dronemap.core.time.Time;
import org.dronemap.ws.door.PhoneDoor;
import org.dronemap.ws.process.ThisProcess;
import org.dronemap.ws.server.Closing;
import org.dronemap.ws.server.DatabaseBuilder;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.HouseBuilder;
import org.dronemap.ws.server.OwnerTasks;
import org.dronemap.ws.server.StartFailure;
import org.dronemap.ws.server.Version;
import org.dronemap.ws.setting.Variables;
import org.dronemap.ws.settings.Settings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.ConfigurableApplicationContext;

/** The server's entry: reads the settings, builds the house, lets vehicles in, starts the faces, and takes all down again at the end. */
public final class Dronemap {
    private static final Logger LOG = LoggerFactory.getLogger(Dronemap.class);

    private Dronemap() {}

    public static void main(String[] arguments) {
        System.exit(run(arguments, System.getenv()));
    }

    /** The exit code; returns when the server was stopped. */
    private static int run(String[] arguments, Map<String, String> environment) {
        Closing closing = new Closing();
        try {
            Settings settings = Settings.fromEnvironment(environment);
            if (arguments.length > 0) {
                int code = new OwnerTasks(settings, closing, new SystemTime()).run(List.of(arguments));
                closing.close();
                return code;
            }
            start(settings, environment, closing);
        } catch (RuntimeException | LinkageError e) {
            closing.close();
            System.err.println(StartFailure.sentence(e));
            return 1;
        }
        return waitForTheEnd(closing);
    }

    private static void start(Settings settings, Map<String, String> environment, Closing closing) {
        Time time = new SystemTime();
        String lastExit = environment.getOrDefault("DRONEMAP_LAST_EXIT", "");
        ThisProcess process = ThisProcess.begin(settings.dataDirectory(), lastExit, time);
        closing.add("the mark of a process that runs", process);
        HouseBuilder builder = new HouseBuilder(settings, closing, time, process.beginning());
        closing.add("the check of itself", process.lookAfter(builder.lanes()));
        House house = builder.open(new DatabaseBuilder(settings).open(closing));
        builder.hear();
        ConfigurableApplicationContext faces = FacesServer.start(settings, new Variables(environment), house);
        closing.add("the faces", faces);
        builder.serve();
        openPhoneDoor(settings, closing);
        String scheme = settings.tls() == null ? "http" : "https";
        LOG.info(
                "Dronemap {} is ready at {}://{}:{}",
                Version.current(),
                scheme,
                settings.bindAddress(),
                faces.getEnvironment().getProperty("local.server.port"));
    }

    private static void openPhoneDoor(Settings settings, Closing closing) {
        PhoneDoor.Place place = PhoneDoors.of(settings);
        if (place != null) {
            closing.add("the door for phones", PhoneDoors.open(place));
            LOG.info("Phones learn to trust this server at {}", PhoneDoors.url(place));
        }
    }

    private static int waitForTheEnd(Closing closing) {
        Thread hook = new Thread(
                () -> {
                    LOG.info("Stopping");
                    closing.close();
                    LOG.info("Stopped");
                },
                "stop");
        Runtime.getRuntime().addShutdownHook(hook);
        try {
            Thread.currentThread().join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return 0;
    }
}
