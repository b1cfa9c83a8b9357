package org.dronemap.ws.wiring;

import java.util.List;
import java.util.Map;
import org.dronemap.core.time.RealTime;
import org.dronemap.core.time.Time;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.plainhttp.PhoneTrustServer;
import org.dronemap.ws.process.ProcessLifecycle;
import org.dronemap.ws.server.BuildVersion;
import org.dronemap.ws.server.DatabaseBuilder;
import org.dronemap.ws.server.MaintenanceTasks;
import org.dronemap.ws.server.ServerBuilder;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.server.ShutdownSequence;
import org.dronemap.ws.server.StartFailureMessage;
import org.dronemap.ws.settings.ServerSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.ConfigurableApplicationContext;

/** Main class of the server: reads the settings, starts endpoints and faces, and shuts all down at the end. */
public final class Dronemap {
    private static final Logger LOG = LoggerFactory.getLogger(Dronemap.class);

    private Dronemap() {}

    public static void main(String[] arguments) {
        System.exit(run(arguments, System.getenv()));
    }

    /** The exit code; returns when the server was stopped. */
    private static int run(String[] arguments, Map<String, String> environment) {
        ShutdownSequence closing = new ShutdownSequence();
        try {
            ServerSettings settings = ServerSettings.fromEnvironment(environment);
            if (arguments.length > 0) {
                int code = new MaintenanceTasks(settings, closing, new RealTime()).run(List.of(arguments));
                closing.close();
                return code;
            }
            start(settings, environment, closing);
        } catch (RuntimeException | LinkageError e) {
            closing.close();
            System.err.println(StartFailureMessage.sentence(e));
            return 1;
        }
        return waitForTheEnd(closing);
    }

    private static void start(ServerSettings settings, Map<String, String> environment, ShutdownSequence closing) {
        Time time = new RealTime();
        String lastExit = environment.getOrDefault("DRONEMAP_LAST_EXIT", "");
        ProcessLifecycle process = ProcessLifecycle.begin(settings.dataDirectory(), lastExit, time);
        closing.add("the mark of a process that runs", process);
        ServerBuilder builder = new ServerBuilder(settings, closing, time, process.beginning());
        closing.add("the check of itself", process.lookAfter(builder.lanes()));
        ServerComponents house = builder.open(new DatabaseBuilder(settings).open(closing));
        builder.openLinks();
        ConfigurableApplicationContext faces =
                FacesServer.start(settings, new EnvironmentVariables(environment), house);
        closing.add("the faces", faces);
        builder.serve();
        openPhoneDoor(settings, closing);
        String scheme = settings.tls() == null ? "http" : "https";
        LOG.info(
                "Dronemap {} is ready at {}://{}:{}",
                BuildVersion.current(),
                scheme,
                settings.bindAddress(),
                faces.getEnvironment().getProperty("local.server.port"));
    }

    private static void openPhoneDoor(ServerSettings settings, ShutdownSequence closing) {
        PhoneTrustServer.Configuration place = PhoneTrustStarter.of(settings);
        if (place != null) {
            closing.add("the door for phones", PhoneTrustStarter.open(place));
            LOG.info("Phones learn to trust this server at {}", PhoneTrustStarter.url(place));
        }
    }

    private static int waitForTheEnd(ShutdownSequence closing) {
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
