#pragma once

namespace sherd {

/// While one of these lives, threads that give way stop where they would share out chunks next
/// (`forEachChunk`): its thread wants all cores now. Those for whom another thread waits go on.
class UrgentWork {
  public:
    UrgentWork();
    ~UrgentWork();
    UrgentWork(const UrgentWork&) = delete;
    UrgentWork& operator=(const UrgentWork&) = delete;
};

/// Whether one lives on the calling thread, so that it need not leave cores to threads that give way.
bool isUrgentHere();

/// While one of these lives, its thread waits for what some other one makes, so that none stops.
class WaitsForAnother {
  public:
    WaitsForAnother();
    ~WaitsForAnother();
    WaitsForAnother(const WaitsForAnother&) = delete;
    WaitsForAnother& operator=(const WaitsForAnother&) = delete;
};

/// What a thread stops for.
enum class GivesWay {
    to_urgent,  ///< work
    to_all,     ///< also where threads that stop for urgent work only are busy on all cores but one
};
/// The calling thread gives way from now on.
void giveWay(GivesWay to);
/// While one of these lives, its thread is busy, if it gives way to urgent work only.
class BusyThread {
  public:
    BusyThread();
    ~BusyThread();
    BusyThread(const BusyThread&) = delete;
    BusyThread& operator=(const BusyThread&) = delete;

  private:
    bool counts_;
};
/// Whether the calling thread is to stop.
bool isToGiveWay();

}  // namespace sherd
